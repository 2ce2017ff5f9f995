# Ground heights and time series, and the files they come from.
target_sources(waterlight_sim PRIVATE
    bathymetry.cpp
    bathymetry_file.cpp
    ground_esri.cpp
    ground_mixer.cpp
    ground_xyz.cpp
    text_file.cpp
    time_series.cpp)
