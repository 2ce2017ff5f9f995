# What keeps a run standing: its state, its checkpoints, and what it does when the world fails.
waterlight_test(state_test SOURCES laws/state_test.cpp LIBRARIES waterlight::sim_vulkan)
