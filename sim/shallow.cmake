# Nonlinear shallow water.
target_sources(waterlight_sim PRIVATE
    shallow_check.cpp
    shallow_disturbance.cpp
    shallow_records.cpp
    shallow_sides.cpp
    shallow_surface.cpp
    shallow_sweep.cpp
    shallow_water.cpp)
