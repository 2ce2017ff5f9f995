# The shallow-water model on a Vulkan device against that on the CPU.
waterlight_test(shallow_backends_test
    SOURCES laws/shallow_backends_test.cpp
    LIBRARIES waterlight::sim_vulkan)
