# The terms by which a wave model is chosen.
waterlight_test(wave_terms_test SOURCES laws/wave_terms.cpp LIBRARIES waterlight::sim)
