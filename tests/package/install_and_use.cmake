# Installs the build in BUILD below SCRATCH, then builds and runs CONSUMER against it.
function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "${ARGN}\n${output}")
    endif()
endfunction()

load_cache(${BUILD} READ_WITH_PREFIX built_ WATERLIGHT_SANITIZE CMAKE_CXX_COMPILER CMAKE_C_COMPILER)
set(as_built -DCMAKE_CXX_COMPILER=${built_CMAKE_CXX_COMPILER} -DCMAKE_C_COMPILER=${built_CMAKE_C_COMPILER})
if(built_WATERLIGHT_SANITIZE)
    list(APPEND as_built -DCMAKE_CXX_FLAGS=-fsanitize=${built_WATERLIGHT_SANITIZE})
endif()
file(REMOVE_RECURSE ${SCRATCH})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/prefix)
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${SCRATCH}/build -G Ninja -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix ${as_built})
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${SCRATCH}/build/embed)
run(${SCRATCH}/build/embed_all)

# Its test kit, in tests of theirs.
run(${CMAKE_COMMAND} -S ${CONSUMER}/test_kit_example -B ${SCRATCH}/test_kit -G Ninja -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix ${as_built})
run(${CMAKE_COMMAND} --build ${SCRATCH}/test_kit)
run(${CMAKE_CTEST_COMMAND} --test-dir ${SCRATCH}/test_kit --output-on-failure --no-tests=error)
