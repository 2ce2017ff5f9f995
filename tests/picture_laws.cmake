# Pictures against the laws of optics.
waterlight_test(picture_laws_test
    SOURCES laws/picture_window.cpp laws/picture_extremes.cpp laws/picture_radiance.cpp
    LIBRARIES waterlight::render fmt::fmt)
