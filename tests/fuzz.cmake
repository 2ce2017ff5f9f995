# Readers under inputs that may hold anything. With WATERLIGHT_FUZZ (Clang, preset fuzz) each target is a libFuzzer
# program; otherwise it reads its seeds and damaged copies of them, as a test.
option(WATERLIGHT_FUZZ "Build the fuzz targets for libFuzzer" OFF)

function(waterlight_fuzz name)
    cmake_parse_arguments(arg "" "" "LIBRARIES;SEEDS" ${ARGN})
    set(folder ${CMAKE_CURRENT_LIST_DIR}/fuzz)
    add_executable(fuzz_${name} ${folder}/${name}.cpp)
    target_include_directories(fuzz_${name} PRIVATE ${PROJECT_SOURCE_DIR})
    target_link_libraries(fuzz_${name} PRIVATE waterlight_flags ${arg_LIBRARIES})
    if(WATERLIGHT_FUZZ)
        target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
    else()
        target_sources(fuzz_${name} PRIVATE ${folder}/replay.cpp)
        add_test(NAME fuzz_${name} COMMAND fuzz_${name} 2000 ${folder}/seeds/${name} ${arg_SEEDS})
        set_tests_properties(fuzz_${name} PROPERTIES LABELS fuzz TIMEOUT 300)
    endif()
endfunction()

waterlight_fuzz(scenario LIBRARIES waterlight::scenarios SEEDS ${PROJECT_SOURCE_DIR}/scenarios)
waterlight_fuzz(overrides LIBRARIES waterlight::scenarios)
foreach(name IN ITEMS vti pvd esri xyz ndbc series)
    waterlight_fuzz(${name} LIBRARIES waterlight::sim)
endforeach()
