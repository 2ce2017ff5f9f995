# The extremes: scenarios that judge themselves, and those that must be refused or warned of.
add_test(NAME extremes COMMAND waterlight check ${PROJECT_SOURCE_DIR}/scenarios/extremes --quiet)
add_test(NAME extremes_refused COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/scenarios/stability.py
    $<TARGET_FILE:waterlight> ${PROJECT_SOURCE_DIR}/scenarios --refused)
set_tests_properties(extremes extremes_refused PROPERTIES TIMEOUT 600)
