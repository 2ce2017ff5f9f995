waterlight_test(quads_test
    SOURCES laws/quads_accuracy.cpp laws/quads_ledger.cpp laws/quads_shares.cpp
    LIBRARIES waterlight::caustics)
waterlight_test(shadows_floor_test
    SOURCES laws/shadows_floor.cpp
    LIBRARIES waterlight::caustics)
waterlight_test(shadows_floor_vulkan_test
    SOURCES laws/shadows_floor_vulkan.cpp
    LIBRARIES waterlight::caustics_vulkan)
