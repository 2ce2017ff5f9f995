# Nonlinear shallow water.
target_sources(waterlight_sim PRIVATE
    shallow_check.cpp
    shallow_disturbance.cpp
    shallow_model.cpp
    shallow_records.cpp
    shallow_sides.cpp
    shallow_surface.cpp
    shallow_sweep.cpp
    shallow_water.cpp
    shallow_waves.cpp)

# The loops of a stage compute far more than they load: the widest vectors pay (measured with AVX-512: a fifth).
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-mprefer-vector-width=512 WATERLIGHT_WIDE_VECTORS)
if(WATERLIGHT_NATIVE AND WATERLIGHT_WIDE_VECTORS)
    set_source_files_properties(shallow_sweep.cpp PROPERTIES
        COMPILE_OPTIONS -mprefer-vector-width=512 SKIP_PRECOMPILE_HEADERS ON)
endif()
