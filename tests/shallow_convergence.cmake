# Tables of convergence of the shallow-water model; run by hand.
add_executable(waterlight_convergence bench/shallow_convergence.cpp)
target_include_directories(waterlight_convergence PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(waterlight_convergence PRIVATE waterlight_flags waterlight::sim fmt::fmt)
