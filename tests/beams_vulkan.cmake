# Light in the water on a Vulkan device against that on the CPU.
waterlight_test(beam_backends_test
    SOURCES laws/beam_backends_test.cpp
    LIBRARIES waterlight::caustics_vulkan)

# Pictures over uneven ground.
waterlight_test(picture_ground_test SOURCES laws/picture_ground.cpp LIBRARIES waterlight::caustics)
