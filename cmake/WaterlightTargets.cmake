# How every target of the project is compiled, said once.

if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()

# -O3 vectorises the row loops. Errno, traps and signed zeros stand in its way and nothing here needs them;
# -ffast-math is never used: a NaN must stay visible.
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

add_library(waterlight_flags INTERFACE)
target_compile_options(waterlight_flags INTERFACE
    -Wall -Wextra -Wshadow -Wnon-virtual-dtor $<$<CXX_COMPILER_ID:GNU>:-Werror>
    -Wno-unknown-pragmas
    -fno-math-errno -fno-trapping-math -fno-signed-zeros
    $<$<BOOL:${WATERLIGHT_NATIVE}>:-march=native>)
# What lets GCC vectorise code written with GLM.
target_compile_definitions(waterlight_flags INTERFACE GLM_FORCE_XYZW_ONLY GLM_FORCE_INLINE)

if(WATERLIGHT_SANITIZE)
    add_compile_options(-fsanitize=${WATERLIGHT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    add_link_options(-fsanitize=${WATERLIGHT_SANITIZE})
endif()

# waterlight_library(NAME SOURCE...): the library waterlight_NAME, alias waterlight::NAME.
function(waterlight_library name)
    add_library(waterlight_${name} STATIC ${ARGN})
    add_library(waterlight::${name} ALIAS waterlight_${name})
    set_target_properties(waterlight_${name} PROPERTIES EXPORT_NAME ${name})
    target_include_directories(waterlight_${name} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/waterlight>)
    target_link_libraries(waterlight_${name} PRIVATE $<BUILD_INTERFACE:waterlight_flags>)
    set_property(GLOBAL APPEND PROPERTY WATERLIGHT_LIBRARIES waterlight_${name})
endfunction()

# waterlight_together(TARGET): its sources are compiled some at a time in one, for most of their time goes to headers that they
# share. For what has no loops to be fast: what is inlined across sources could round otherwise. A source then sees the names of
# those before it, and may take one of theirs for its own unnoticed. Not for Clang, as below: a build for a sanitizer notices.
function(waterlight_together target)
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    endif()
endfunction()

# waterlight_precompile(TARGET [HEADER...]): what most of its sources include (and HEADER) is compiled once.
# waterlight_precompile(TARGET REUSE_FROM OTHER): with what OTHER compiled.
# Not for Clang, which has the sanitizers and the fuzzers: there the sources must stand on their own.
function(waterlight_precompile target)
    if(NOT CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        return()
    endif()
    if("${ARGV1}" STREQUAL REUSE_FROM)
        target_precompile_headers(${target} ${ARGN})
    else()
        target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp ${ARGN})
    endif()
endfunction()
