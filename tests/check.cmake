# Scenarios as tests: the command `check` itself is tested.
waterlight_test(check_parts_test SOURCES unit/check_parts_test.cpp unit/check_refusals_test.cpp LIBRARIES waterlight_app)
waterlight_test(check_test SOURCES scenarios/check_test.cpp LIBRARIES waterlight::gpu)
target_compile_definitions(check_test PRIVATE
    WATERLIGHT_PROGRAM="$<TARGET_FILE:waterlight>"
    WATERLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
add_dependencies(check_test waterlight)
