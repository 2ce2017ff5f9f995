# Writes the words of the SPIR-V module SPIRV into HEADER as the span waterlight::shaders::NAME.
file(READ ${SPIRV} bytes HEX)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1, " words "${bytes}")
file(WRITE ${HEADER} "#pragma once

#include <cstdint>
#include <span>

namespace waterlight::shaders {

inline constexpr std::uint32_t ${NAME}_words[] = {${words}};
inline constexpr std::span<const std::uint32_t> ${NAME}{${NAME}_words};

}  // namespace waterlight::shaders
")
