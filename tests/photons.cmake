waterlight_test(photons_test
    SOURCES laws/photons_waves.cpp
    LIBRARIES waterlight::caustics)
