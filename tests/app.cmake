find_package(nlohmann_json REQUIRED)

# The program, from its parts to the shipped scenarios.
waterlight_test(app_record_test SOURCES unit/app_record_test.cpp unit/app_flashes_test.cpp LIBRARIES waterlight_app)

waterlight_test(program_test
    SOURCES scenarios/bad_scenarios_test.cpp scenarios/outputs_test.cpp scenarios/shallow_outputs_test.cpp
    LIBRARIES waterlight::sim waterlight_sim_files nlohmann_json::nlohmann_json fmt::fmt)
waterlight_test(shipped_scenarios_test
    SOURCES scenarios/shipped_scenarios_test.cpp
    LIBRARIES waterlight::scenarios waterlight::caustics_vulkan nlohmann_json::nlohmann_json)
foreach(test IN ITEMS program_test shipped_scenarios_test)
    target_compile_definitions(${test} PRIVATE
        WATERLIGHT_PROGRAM="$<TARGET_FILE:waterlight>"
        WATERLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
    add_dependencies(${test} waterlight)
endforeach()

# The laboratory's waves; skipped without its measurements.
add_test(NAME measured_waves COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/scenarios/measured_waves.py
    $<TARGET_FILE:waterlight> ${PROJECT_SOURCE_DIR}/scenarios)
set_tests_properties(measured_waves PROPERTIES TIMEOUT 600 SKIP_RETURN_CODE 77)

# The installed package serves a project of someone else.
add_test(NAME package COMMAND ${CMAKE_COMMAND}
    -DBUILD=${PROJECT_BINARY_DIR} -DCONSUMER=${CMAKE_CURRENT_LIST_DIR}/package
    -DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/package
    -P ${CMAKE_CURRENT_LIST_DIR}/package/install_and_use.cmake)
set_tests_properties(package PROPERTIES TIMEOUT 600)

# What ./waterlight does around a build.
add_test(NAME start_script COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/scenarios/start_script_test.py ${PROJECT_SOURCE_DIR})
set_tests_properties(start_script PROPERTIES TIMEOUT 120)
