# The floor map of a scenario by each of its methods.
waterlight_test(floor_methods_test
    SOURCES unit/floor_methods_test.cpp
    LIBRARIES waterlight_app fmt::fmt nlohmann_json::nlohmann_json)
