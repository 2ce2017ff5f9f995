# Exact solutions and initial states of the shallow-water model.
target_sources(waterlight_sim PRIVATE
    shallow_bump.cpp
    shallow_exact.cpp
    shallow_initial.cpp
    shallow_means.cpp)
