waterlight_test(floor_map_test
    SOURCES laws/floor_map_test.cpp
    LIBRARIES waterlight::caustics)
waterlight_test(truth_test
    SOURCES laws/truth_test.cpp
    LIBRARIES waterlight::caustics)
