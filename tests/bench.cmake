find_package(benchmark REQUIRED)

# Every benchmark of the project; areas add their sources.
add_executable(waterlight_bench
    bench/main.cpp bench/beams.cpp bench/floor_photons.cpp bench/floor_quads.cpp bench/floor_splat.cpp bench/floor_two_pass.cpp bench/frame.cpp bench/roof.cpp bench/waves_airy.cpp
    bench/waves_shallow_water.cpp)
target_include_directories(waterlight_bench PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(waterlight_bench PRIVATE
    waterlight_flags waterlight::sim waterlight::sim_vulkan waterlight::caustics_vulkan waterlight::render benchmark::benchmark fmt::fmt)
