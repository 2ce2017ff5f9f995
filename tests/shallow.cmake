# Laws of the shallow-water model.
waterlight_test(shallow_tests
    SOURCES
        laws/shallow_records.cpp
        laws/shallow_refusals.cpp
        laws/shallow_rest.cpp
        laws/shallow_riemann.cpp
        laws/shallow_sides.cpp
        laws/shallow_threads.cpp
        laws/shallow_energy.cpp
        laws/shallow_friction.cpp
        laws/shallow_orders.cpp
        laws/shallow_step.cpp
        laws/shallow_volume.cpp
    LIBRARIES waterlight::sim)

# A million steps: some seconds.
waterlight_test(shallow_long_test SOURCES laws/shallow_long.cpp LIBRARIES waterlight::sim)
