# The light a scene may ask for.
waterlight_test(light_test
    SOURCES laws/sun_disc_test.cpp laws/relief_test.cpp laws/walls_test.cpp laws/water_colour_test.cpp
    LIBRARIES waterlight::caustics)
target_sources(waterlight_bench PRIVATE ${CMAKE_CURRENT_LIST_DIR}/bench/light.cpp)
