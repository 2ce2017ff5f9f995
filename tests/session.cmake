# Water disturbed by hand, and the running scenario that a person plays with.
waterlight_test(disturb_test SOURCES laws/disturb.cpp LIBRARIES waterlight::sim)
waterlight_test(disturb_vulkan_test SOURCES laws/disturb_vulkan.cpp LIBRARIES waterlight::sim_vulkan)
