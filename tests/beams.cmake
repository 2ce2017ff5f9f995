waterlight_test(beams_physics_test
    SOURCES laws/beams_ground.cpp laws/beams_reflected.cpp
    LIBRARIES waterlight::caustics)
