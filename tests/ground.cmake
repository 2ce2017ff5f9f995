# Ground heights and time series, and the files they come from.
waterlight_test(time_series_tests SOURCES unit/time_series.cpp LIBRARIES waterlight::sim fmt::fmt)
