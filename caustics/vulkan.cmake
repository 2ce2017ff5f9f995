include(WaterlightShaders)
waterlight_library(caustics_vulkan beam_image_vulkan.cpp beam_renderer_vulkan.cpp beam_volume_vulkan.cpp floor_vulkan.cpp
    splat/splat_vulkan.cpp)
waterlight_shaders(waterlight_caustics_vulkan
    shaders/beam_cells.comp shaders/beam_outline.vert shaders/beam_light.frag shaders/beam_fields.comp
    shaders/floor_land.comp shaders/floor_land_shaded.comp shaders/floor_gather.comp shaders/floor_gather_adaptive.comp shaders/floor_sum.comp
    splat/shaders/splat_water.comp splat/shaders/splat_flights.comp splat/shaders/splat_shape.comp
    splat/shaders/splat_box.vert splat/shaders/splat_light.frag)
target_link_libraries(waterlight_caustics_vulkan PUBLIC waterlight::caustics waterlight::gpu PRIVATE fmt::fmt)
