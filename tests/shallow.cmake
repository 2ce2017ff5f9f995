# Laws of the shallow-water model.
waterlight_test(shallow_tests
    SOURCES
        laws/shallow_rest.cpp
    LIBRARIES waterlight::sim)
