waterlight_test(gpu_layer_test
    SOURCES unit/gpu_device_test.cpp unit/gpu_pass_test.cpp unit/gpu_raster_test.cpp
    LIBRARIES waterlight::gpu)
waterlight_shaders(gpu_layer_test unit/shaders/gpu_scale.comp unit/shaders/gpu_texels.comp unit/shaders/gpu_strip.vert unit/shaders/gpu_value.frag
    unit/shaders/gpu_layers.vert unit/shaders/gpu_colour.frag unit/shaders/gpu_halved.frag)

waterlight_test(floor_backends_test
    SOURCES laws/floor_backends_test.cpp
    LIBRARIES waterlight::caustics_vulkan)
