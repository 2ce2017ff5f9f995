# What keeps a run standing: its state, its checkpoints, and what it does when the world fails.
waterlight_test(state_test SOURCES laws/state_test.cpp LIBRARIES waterlight::sim_vulkan)

waterlight_test(faults_test
    SOURCES scenarios/determinism_test.cpp scenarios/faults_test.cpp scenarios/resume_test.cpp
    LIBRARIES waterlight::sim waterlight_sim_files nlohmann_json::nlohmann_json)
target_compile_definitions(faults_test PRIVATE
    WATERLIGHT_PROGRAM="$<TARGET_FILE:waterlight>"
    WATERLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
add_dependencies(faults_test waterlight)
