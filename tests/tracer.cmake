# Ray-traced pictures of scenes with objects.
waterlight_test(traced_test
    SOURCES laws/traced_furnace.cpp laws/traced_glass.cpp laws/traced_objects.cpp
    LIBRARIES waterlight::render OpenMP::OpenMP_CXX)
waterlight_test(traced_and_drawn_test SOURCES laws/traced_and_drawn.cpp LIBRARIES waterlight::render fmt::fmt)
