# Cameras that the mouse moves, and what is under it.
waterlight_test(window_parts_test
    SOURCES unit/orbit_camera_test.cpp unit/pick_test.cpp
    LIBRARIES waterlight::render)

# On a virtual screen, where Xvfb is installed.
waterlight_test(presenter_test
    SOURCES unit/presenter_test.cpp
    LIBRARIES waterlight_window glfw)
waterlight_shaders(presenter_test unit/shaders/gpu_layers.vert unit/shaders/gpu_colour.frag)
target_compile_definitions(presenter_test PRIVATE WATERLIGHT_LAYERS="${CMAKE_CURRENT_BINARY_DIR}/layers")
add_dependencies(presenter_test lost_device_layer)
