waterlight_test(objects_test
    SOURCES laws/objects.cpp laws/objects_scene.cpp
    LIBRARIES waterlight::caustics)
