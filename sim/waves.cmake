# Sources, the linear model and the prescribed surfaces.
pkg_check_modules(FFTW3 REQUIRED IMPORTED_TARGET fftw3)
target_sources(waterlight_sim PRIVATE
    disturbance.cpp
    gerstner.cpp
    gerstner_rows.cpp
    linear.cpp
    linear_energy.cpp
    linear_initial.cpp
    linear_sweep.cpp
    prescribed.cpp
    prescribed_file.cpp
    prescribed_formula.cpp
    round_spot.cpp
    runup.cpp
    sources.cpp
    sponge.cpp
    surface_sums.cpp
    wave_terms.cpp)
target_link_libraries(waterlight_sim PRIVATE PkgConfig::FFTW3 waterlight_sim_files)
