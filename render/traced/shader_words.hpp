// The words of a shader's text, for C++ in single precision: those of sim/kernels/real.hpp, the names of GLSL's types,
// and arithmetic of vectors with numbers of any type.
#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>

#include "sim/kernels/real.hpp"

namespace waterlight::f32 {

using glm::exp2;
using glm::ivec2;
using glm::log2;
using glm::mix;
using glm::vec2;
using glm::vec3;
using glm::vec4;

// GLSL reads 0.5 as a float; C++ would find no product of a double and a vec3.
#define WATERLIGHT_SHADER_ARITHMETIC(VECTOR)                                          \
    KERNEL VECTOR operator*(double a, VECTOR b) { return static_cast<float>(a) * b; } \
    KERNEL VECTOR operator+(VECTOR a, double b) { return a + static_cast<float>(b); } \
    KERNEL VECTOR operator-(VECTOR a, double b) { return a - static_cast<float>(b); } \
    KERNEL VECTOR operator/(VECTOR a, double b) { return a / static_cast<float>(b); }
WATERLIGHT_SHADER_ARITHMETIC(glm::vec2)
WATERLIGHT_SHADER_ARITHMETIC(glm::vec3)
#undef WATERLIGHT_SHADER_ARITHMETIC

}  // namespace waterlight::f32
