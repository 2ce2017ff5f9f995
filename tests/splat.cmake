waterlight_test(splat_test
    SOURCES laws/splat_landing.cpp laws/splat_objects.cpp laws/splat_water.cpp
    LIBRARIES waterlight::caustics)
waterlight_test(splat_backends_test
    SOURCES laws/splat_backends_test.cpp
    LIBRARIES waterlight::caustics_vulkan)
