# Beams that objects stop, and the same on a Vulkan device.
waterlight_test(shadows_beams_test
    SOURCES laws/shadows_beams.cpp laws/shadows_shapes.cpp laws/shadows_pictures.cpp
    LIBRARIES waterlight::caustics)
waterlight_test(shadows_backends_test
    SOURCES laws/shadows_backends.cpp
    LIBRARIES waterlight::caustics_vulkan)
