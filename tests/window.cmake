# Cameras that the mouse moves, and what is under it.
waterlight_test(window_parts_test
    SOURCES unit/orbit_camera_test.cpp unit/pick_test.cpp
    LIBRARIES waterlight::render)
waterlight_test(view_parts_test
    SOURCES unit/view_controls_test.cpp unit/view_parts_test.cpp
    LIBRARIES waterlight_view)

# On a virtual screen, where Xvfb is installed.
waterlight_test(presenter_test
    SOURCES unit/presenter_test.cpp
    LIBRARIES waterlight_window glfw)
waterlight_shaders(presenter_test unit/shaders/gpu_layers.vert unit/shaders/gpu_colour.frag)
target_compile_definitions(presenter_test PRIVATE WATERLIGHT_LAYERS="${CMAKE_CURRENT_BINARY_DIR}/layers")
add_dependencies(presenter_test lost_device_layer)

# The window as a person uses it, where xdotool is installed too.
foreach(case IN ITEMS ripple refusal endurance lost_device no_display)
    add_test(NAME window_${case} COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/scenarios/window_test.py
        $<TARGET_FILE:waterlight> ${PROJECT_SOURCE_DIR}/scenarios ${case})
    set_tests_properties(window_${case} PROPERTIES TIMEOUT 900 SKIP_RETURN_CODE 77
        ENVIRONMENT "WATERLIGHT_LAYERS=${CMAKE_CURRENT_BINARY_DIR}/layers")
endforeach()
