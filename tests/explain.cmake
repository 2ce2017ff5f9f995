# The terms by which a wave model is chosen, the choice, and the truth that judges it.
waterlight_test(wave_terms_test SOURCES laws/wave_terms.cpp LIBRARIES waterlight::sim)
waterlight_test(choose_test SOURCES unit/choose_test.cpp LIBRARIES waterlight::scenarios)

add_test(NAME wave_truths COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/scenarios/wave_truths.py)
set_tests_properties(wave_truths PROPERTIES TIMEOUT 600)
