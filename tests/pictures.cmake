# Pictures of scenes: what a scenario says of them.
waterlight_test(scenario_picture_test SOURCES unit/scenario_picture_test.cpp LIBRARIES waterlight::scenarios)
