# Water disturbed by hand, and the running scenario that a person plays with.
find_package(tomlplusplus REQUIRED)

waterlight_test(disturb_test SOURCES laws/disturb.cpp LIBRARIES waterlight::sim)
waterlight_test(disturb_vulkan_test SOURCES laws/disturb_vulkan.cpp LIBRARIES waterlight::sim_vulkan)
waterlight_test(rewrite_test
    SOURCES unit/rewrite_test.cpp
    LIBRARIES waterlight::scenarios tomlplusplus::tomlplusplus fmt::fmt)
target_compile_definitions(rewrite_test PRIVATE WATERLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
waterlight_test(session_test
    SOURCES unit/session_test.cpp unit/session_threads_test.cpp unit/session_edits_test.cpp LIBRARIES waterlight_app)
target_compile_definitions(session_test PRIVATE WATERLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
