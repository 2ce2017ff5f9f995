# What keeps a run standing: its state, its checkpoints, and what it does when the world fails.
waterlight_test(state_test SOURCES laws/state_test.cpp LIBRARIES waterlight::sim_vulkan)

waterlight_test(faults_test
    SOURCES scenarios/determinism_test.cpp scenarios/faults_test.cpp scenarios/resume_test.cpp
    LIBRARIES waterlight::sim waterlight_sim_files nlohmann_json::nlohmann_json)
target_compile_definitions(faults_test PRIVATE
    WATERLIGHT_PROGRAM="$<TARGET_FILE:waterlight>"
    WATERLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
add_dependencies(faults_test waterlight)

# A Vulkan layer that loses its device, and the file by which the loader finds it.
add_library(lost_device_layer MODULE support/lost_device_layer.cpp)
target_link_libraries(lost_device_layer PRIVATE waterlight_flags)
file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/layers/lost_device_layer.json
    INPUT ${CMAKE_CURRENT_LIST_DIR}/support/lost_device_layer.json.in)
target_compile_definitions(faults_test PRIVATE WATERLIGHT_LAYERS="${CMAKE_CURRENT_BINARY_DIR}/layers")
add_dependencies(faults_test lost_device_layer)

if(TARGET waterlight_bench)
    target_sources(waterlight_bench PRIVATE bench/checkpoint.cpp)
    target_link_libraries(waterlight_bench PRIVATE waterlight::export)
endif()
