include(WaterlightShaders)
waterlight_library(caustics_vulkan floor_vulkan.cpp)
waterlight_shaders(waterlight_caustics_vulkan
    shaders/floor_land.comp shaders/floor_gather.comp shaders/floor_gather_adaptive.comp shaders/floor_sum.comp)
target_link_libraries(waterlight_caustics_vulkan PUBLIC waterlight::caustics waterlight::gpu PRIVATE fmt::fmt)
