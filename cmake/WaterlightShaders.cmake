# Shaders: GLSL to SPIR-V at build time, optimised, validated, embedded as arrays of C++.

find_program(GLSLANG_VALIDATOR glslangValidator REQUIRED)
find_program(SPIRV_OPT spirv-opt REQUIRED)
find_program(SPIRV_VAL spirv-val REQUIRED)

# waterlight_shaders(TARGET SHADER...): for shaders/name.comp the target may include "shaders/name.hpp", which holds the
# span waterlight::shaders::name. A shader includes kernel texts by their path from the root of the project; an edit of
# any of them builds it anew.
function(waterlight_shaders target)
    set(embed ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/EmbedShader.cmake)
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_embedded/shaders)
    file(MAKE_DIRECTORY ${folder})
    foreach(shader IN LISTS ARGN)
        get_filename_component(name ${shader} NAME_WE)
        set(source ${CMAKE_CURRENT_SOURCE_DIR}/${shader})
        set(stem ${folder}/${name})
        add_custom_command(
            OUTPUT ${stem}.unoptimised.spv ${stem}.hpp
            COMMAND ${GLSLANG_VALIDATOR} --quiet --target-env vulkan1.3 -I${PROJECT_SOURCE_DIR}
                --depfile ${stem}.d -o ${stem}.unoptimised.spv ${source}
            COMMAND ${SPIRV_OPT} -O --target-env=vulkan1.3 ${stem}.unoptimised.spv -o ${stem}.spv
            COMMAND ${SPIRV_VAL} --target-env vulkan1.3 ${stem}.spv
            COMMAND ${CMAKE_COMMAND} -DSPIRV=${stem}.spv -DNAME=${name} -DHEADER=${stem}.hpp
                -P ${embed}
            DEPENDS ${source} ${embed}
            DEPFILE ${stem}.d
            COMMENT "Shader ${shader}"
            VERBATIM)
        target_sources(${target} PRIVATE ${stem}.hpp)
    endforeach()
    target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${target}_embedded)
endfunction()
