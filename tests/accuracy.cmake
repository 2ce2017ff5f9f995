# How wrong each method is and what it costs: docs/accuracy.md.
add_executable(waterlight_accuracy
    bench/accuracy/main.cpp bench/accuracy/report.cpp bench/accuracy/scenes.cpp bench/accuracy/floor.cpp
    bench/accuracy/light.cpp bench/accuracy/beams.cpp bench/accuracy/waves.cpp)
target_include_directories(waterlight_accuracy PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(waterlight_accuracy PRIVATE
    waterlight_flags waterlight::sim waterlight::caustics_vulkan fmt::fmt)
waterlight_together(waterlight_accuracy)
add_test(NAME Accuracy.QuickReportParsesAndConverges COMMAND /usr/bin/python3
    ${CMAKE_CURRENT_LIST_DIR}/bench/accuracy/check_report.py $<TARGET_FILE:waterlight_accuracy>)
# Threads that wait should soon sleep: other tests run beside them.
set_tests_properties(Accuracy.QuickReportParsesAndConverges PROPERTIES
    TIMEOUT 300 LABELS accuracy ENVIRONMENT GOMP_SPINCOUNT=1000)
