# Exact solutions and initial states of the shallow-water model.
waterlight_test(shallow_exact_test
    SOURCES
        laws/shallow_exact.cpp
        laws/shallow_initial.cpp
        laws/shallow_shocks.cpp
    LIBRARIES waterlight::sim)
