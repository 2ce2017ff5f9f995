waterlight_test(photons_test
    SOURCES laws/photons_waves.cpp laws/photons_objects.cpp laws/photons_glass.cpp
        laws/photons_lamps.cpp laws/photons_passes.cpp laws/photons_screen.cpp
    LIBRARIES waterlight::caustics)
