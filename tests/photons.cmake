waterlight_test(photons_test
    SOURCES laws/photons_waves.cpp laws/photons_objects.cpp laws/photons_lamps.cpp
    LIBRARIES waterlight::caustics)
