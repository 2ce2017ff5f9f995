# Wave models on a Vulkan device.
include(WaterlightShaders)
waterlight_library(sim_vulkan shallow_water_vulkan.cpp)
waterlight_shaders(waterlight_sim_vulkan
    shaders/shallow_flux.comp shaders/shallow_frame.comp shaders/shallow_record.comp shaders/shallow_update.comp)
target_link_libraries(waterlight_sim_vulkan PUBLIC waterlight::sim waterlight::gpu)
