waterlight_test(floor_map_test
    SOURCES laws/floor_map_test.cpp laws/floor_footprint_test.cpp
    LIBRARIES waterlight::caustics)
waterlight_test(truth_test
    SOURCES laws/truth_test.cpp
    LIBRARIES waterlight::caustics)
waterlight_test(beams_test
    SOURCES laws/beams_along.cpp laws/beams_kernel.cpp laws/beams_grid.cpp laws/beams_volume.cpp
        laws/beams_image.cpp
    LIBRARIES waterlight::caustics)
