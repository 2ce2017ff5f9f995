# The airy model, its spectra and NDBC's files.
waterlight_test(airy_test
    SOURCES
        laws/airy_absorbing.cpp
        laws/airy_dispersion.cpp
        laws/airy_sources.cpp
        laws/airy_standing.cpp
    LIBRARIES waterlight::sim)
waterlight_test(spectrum_test
    SOURCES
        laws/spectrum_models.cpp
        laws/spectrum_sea.cpp
    LIBRARIES waterlight::sim)
waterlight_test(ndbc_test
    SOURCES
        unit/ndbc_buoy.cpp
        unit/ndbc_reader.cpp
    LIBRARIES waterlight::sim)
