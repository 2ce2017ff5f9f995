# That a sanitizer is silent means something only where it sees what it must. Included last: it knows the other tests.
if(WATERLIGHT_SANITIZE)
    add_executable(sanitizer_canary support/sanitizer_canary.cpp)
    target_link_libraries(sanitizer_canary PRIVATE waterlight_flags OpenMP::OpenMP_CXX)
endif()

# waterlight_sees(FAULT TEXT): the sanitizer's report of the fault has this text.
function(waterlight_sees fault text)
    add_test(NAME sanitizer_sees_${fault} COMMAND sanitizer_canary ${fault})
    set_tests_properties(sanitizer_sees_${fault} PROPERTIES PASS_REGULAR_EXPRESSION ${text} LABELS sanitizers)
endfunction()

if(WATERLIGHT_SANITIZE MATCHES "address")
    add_library(keep_modules MODULE support/keep_modules.cpp)
    target_compile_options(keep_modules PRIVATE -fno-sanitize=all)
    target_link_options(keep_modules PRIVATE -fno-sanitize=all)
    waterlight_sees(beyond_the_end "heap-buffer-overflow")
    waterlight_sees(leak "LeakSanitizer: detected memory leaks")
endif()
if(WATERLIGHT_SANITIZE MATCHES "undefined")
    waterlight_sees(overflow "signed integer overflow")
endif()
if(WATERLIGHT_SANITIZE MATCHES "thread")
    target_sources(session_test PRIVATE support/openmp_thread_0.cpp)
    waterlight_sees(race "ThreadSanitizer: data race")
    # And takes no order that OpenMP keeps for a race.
    add_test(NAME sanitizer_sees_order COMMAND sanitizer_canary order)
    set_tests_properties(sanitizer_sees_order PROPERTIES LABELS sanitizers)
endif()

# Which tests are left out under a sanitizer, and why. One that is no case of GoogleTest is known here already: its runs
# take more than ten minutes, and other tests step their models as well.
set_tests_properties(measured_waves PROPERTIES LABELS not_under_sanitizers)
# It measures how much memory the program holds, of which what is freed and kept aside to be watched is no part.
set_tests_properties(window_endurance PROPERTIES
    ENVIRONMENT_MODIFICATION "ASAN_OPTIONS=string_append: quarantine_size_mb=4")
set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${CMAKE_CURRENT_LIST_DIR}/support/sanitizers_left_out.cmake)
