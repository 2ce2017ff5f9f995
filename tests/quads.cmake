waterlight_test(quads_test
    SOURCES laws/quads_accuracy.cpp laws/quads_ledger.cpp laws/quads_shares.cpp
    LIBRARIES waterlight::caustics)
