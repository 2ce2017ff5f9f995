# The scenario reader.
waterlight_test(scenario_test
    SOURCES
        unit/scenario_beams_test.cpp
        unit/scenario_build_shallow_test.cpp
        unit/scenario_errors_test.cpp
        unit/scenario_light_test.cpp
        unit/scenario_objects_test.cpp
        unit/scenario_overrides_test.cpp
        unit/scenario_reader_test.cpp
        unit/scenario_shallow_test.cpp
    LIBRARIES waterlight::scenarios)
