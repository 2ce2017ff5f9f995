# Ground heights, and text files of numbers.
target_sources(waterlight_sim PRIVATE
    text_file.cpp
    time_series.cpp)
