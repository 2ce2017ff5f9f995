# Pictures of a scene against closed forms.
waterlight_test(render_scene_test
    SOURCES laws/render_furnace.cpp
    LIBRARIES waterlight::render)
