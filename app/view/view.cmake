# The window on a running scenario.
add_library(waterlight_view STATIC
    view/controls.cpp
    view/panels.cpp
    view/panels_picture.cpp
    view/panels_settings.cpp
    view/picture_size.cpp
    view/screenshot.cpp
    view/view.cpp
    view/view_state.cpp
)
target_link_libraries(waterlight_view
    PUBLIC waterlight_app waterlight::render waterlight_window
    PRIVATE waterlight_flags fmt::fmt)
waterlight_together(waterlight_view)
