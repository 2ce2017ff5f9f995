# Installs the build in BUILD below SCRATCH, then builds and runs CONSUMER against it.
function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "${ARGN}\n${output}")
    endif()
endfunction()

load_cache(${BUILD} READ_WITH_PREFIX built_ WATERLIGHT_SANITIZE)
if(built_WATERLIGHT_SANITIZE)
    set(sanitize -DCMAKE_CXX_FLAGS=-fsanitize=${built_WATERLIGHT_SANITIZE})
    set(ENV{LSAN_OPTIONS} detect_leaks=0) # the Vulkan driver's own
endif()
file(REMOVE_RECURSE ${SCRATCH})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/prefix)
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${SCRATCH}/build -G Ninja -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix ${sanitize})
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${SCRATCH}/build/embed)
run(${SCRATCH}/build/embed_all)

# Its test kit, in tests of theirs.
run(${CMAKE_COMMAND} -S ${CONSUMER}/test_kit_example -B ${SCRATCH}/test_kit -G Ninja -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix ${sanitize})
run(${CMAKE_COMMAND} --build ${SCRATCH}/test_kit)
run(${CMAKE_CTEST_COMMAND} --test-dir ${SCRATCH}/test_kit --output-on-failure --no-tests=error)
