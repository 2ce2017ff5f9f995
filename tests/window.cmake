# The window, its cameras and what is under the mouse.
waterlight_test(window_parts_test
    SOURCES unit/orbit_camera_test.cpp unit/pick_test.cpp
    LIBRARIES waterlight_window)
