# Sources, the linear model and the prescribed surfaces.
target_sources(waterlight_sim PRIVATE
    sources.cpp)
