# Pictures against geometry and radiance that the tests predict themselves.
waterlight_test(picture_optics_test
    SOURCES laws/picture_joints.cpp laws/picture_calm.cpp laws/picture_furnace.cpp laws/picture_sun.cpp
            laws/picture_edges.cpp laws/picture_invisible.cpp laws/picture_rays.cpp
            laws/picture_variants.cpp
    LIBRARIES waterlight::render fmt::fmt)
