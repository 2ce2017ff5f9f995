waterlight_test(beams_physics_test
    SOURCES laws/beams_ground.cpp
    LIBRARIES waterlight::caustics)
