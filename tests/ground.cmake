# Ground heights and time series, and the files they come from.
waterlight_test(time_series_tests SOURCES unit/time_series.cpp LIBRARIES waterlight::sim fmt::fmt)
waterlight_test(bathymetry_tests
    SOURCES unit/bathymetry_files.cpp unit/bathymetry_resampling.cpp unit/bathymetry_shapes.cpp
    LIBRARIES waterlight::sim fmt::fmt)
