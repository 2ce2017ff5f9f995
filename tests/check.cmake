# Scenarios as tests: the command `check` itself is tested.
waterlight_test(check_parts_test SOURCES unit/check_parts_test.cpp unit/check_refusals_test.cpp LIBRARIES waterlight_app)
waterlight_test(check_test
    SOURCES scenarios/check_test.cpp scenarios/check_comparisons_test.cpp LIBRARIES waterlight::gpu)
target_compile_definitions(check_test PRIVATE
    WATERLIGHT_PROGRAM="$<TARGET_FILE:waterlight>"
    WATERLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
add_dependencies(check_test waterlight)
# What the closed forms say, in numbers; and the mutations that these must notice still fit the source.
add_test(NAME scenario_laws COMMAND waterlight check ${PROJECT_SOURCE_DIR}/scenarios/laws --quiet)
add_test(NAME mutants_fit COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/scenarios/mutants.py ${PROJECT_SOURCE_DIR} --list)
set_tests_properties(scenario_laws PROPERTIES TIMEOUT 600)
