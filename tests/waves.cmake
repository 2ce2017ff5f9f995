# Laws of the sources, the linear model and the prescribed surfaces.
waterlight_test(waves_linear_tests
    SOURCES laws/linear_dispersion.cpp laws/linear_sides.cpp laws/linear_sources.cpp laws/linear_stability.cpp
    LIBRARIES waterlight::sim)

waterlight_test(waves_sources_tests
    SOURCES unit/sources_drops.cpp unit/sources_wavemaker.cpp
    LIBRARIES waterlight::sim)

waterlight_test(runup_tests SOURCES unit/runup.cpp LIBRARIES waterlight::sim)

waterlight_test(waves_prescribed_tests
    SOURCES laws/prescribed_file.cpp laws/prescribed_formula.cpp laws/prescribed_gerstner.cpp
    LIBRARIES waterlight::sim)

if(TARGET waterlight_bench)
    target_sources(waterlight_bench PRIVATE bench/waves_linear.cpp)
endif()
