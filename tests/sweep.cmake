find_package(nlohmann_json REQUIRED)

# Settings, their front and table; the sweep as a user runs it, killed and started again.
waterlight_test(sweep_unit_test SOURCES unit/sweep_test.cpp LIBRARIES waterlight_app)
waterlight_test(sweep_test SOURCES scenarios/sweep_test.cpp LIBRARIES waterlight::sim_files nlohmann_json::nlohmann_json)
target_compile_definitions(sweep_test PRIVATE
    WATERLIGHT_PROGRAM="$<TARGET_FILE:waterlight>"
    WATERLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
add_dependencies(sweep_test waterlight)

# What is estimated against what is true.
waterlight_test(error_estimates_test
    SOURCES laws/floor_error_estimate.cpp laws/wave_error_estimate.cpp
    LIBRARIES waterlight_app)
