# Ray-traced pictures of scenes with objects.
waterlight_test(traced_test
    SOURCES laws/traced_furnace.cpp laws/traced_glass.cpp laws/traced_objects.cpp
    LIBRARIES waterlight::render OpenMP::OpenMP_CXX)
waterlight_test(traced_and_drawn_test SOURCES laws/traced_and_drawn.cpp LIBRARIES waterlight::render fmt::fmt)

# The ways to a caustic side by side: docs/methods.md.
add_executable(waterlight_methods
    bench/accuracy/report.cpp bench/accuracy/scenes.cpp bench/methods/abilities.cpp bench/methods/cups.cpp
    bench/methods/main.cpp bench/methods/memory.cpp bench/methods/methods.cpp bench/methods/pool.cpp
    bench/methods/waves.cpp)
target_include_directories(waterlight_methods PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(waterlight_methods PRIVATE
    waterlight_flags waterlight::scenarios waterlight::render fmt::fmt)
waterlight_together(waterlight_methods)
add_test(NAME Methods.QuickReportConvergesAndKeepsTheLight COMMAND /usr/bin/python3
    ${CMAKE_CURRENT_LIST_DIR}/bench/methods/check_report.py $<TARGET_FILE:waterlight_methods>
    ${PROJECT_SOURCE_DIR}/scenarios)
set_tests_properties(Methods.QuickReportConvergesAndKeepsTheLight PROPERTIES
    TIMEOUT 600 LABELS methods ENVIRONMENT GOMP_SPINCOUNT=1000)
