# Pictures of scenes: what a scenario says of them, what a run makes of it, and whether they look as they did.
waterlight_test(scenario_picture_test SOURCES unit/scenario_picture_test.cpp LIBRARIES waterlight::scenarios)
waterlight_test(picture_parts_test
    SOURCES unit/floor_colours_test.cpp unit/regular_frames_test.cpp
    LIBRARIES waterlight_app)
waterlight_test(pictures_test
    SOURCES scenarios/pictures_test.cpp
    LIBRARIES nlohmann_json::nlohmann_json fmt::fmt)
target_compile_definitions(pictures_test PRIVATE
    WATERLIGHT_PROGRAM="$<TARGET_FILE:waterlight>"
    WATERLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
add_dependencies(pictures_test waterlight)

add_test(NAME picture_references COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/scenarios/picture_references.py
    $<TARGET_FILE:waterlight> ${PROJECT_SOURCE_DIR})
set_tests_properties(picture_references PROPERTIES TIMEOUT 600 SKIP_RETURN_CODE 77)

waterlight_test(render_overlay_test SOURCES laws/render_overlay.cpp LIBRARIES waterlight::render)
