// The words in which a kernel text is written, for C++. A kernel text is a .glsl file of pure functions on real, real2
// and real3; C++ includes it once inside namespace f32 (production) and once inside f64 (reference), through the header
// of the same name beside it. A shader includes sim/kernels/real.glsl instead. In a text:
//   - start each function with KERNEL; return structs, take no out parameters;
//   - write every number as real(0.5), so that float code stays float;
//   - call min, max, abs, sqrt, cbrt, exp, pow, floor, clamp, tanh, sin, cos, dot, cross unqualified.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#define KERNEL [[maybe_unused]] static inline

namespace waterlight {

/// Cube root of x >= 0 in two steps of Newton's from a third of the exponent, to 3e-7: GCC vectorises it, and not
/// std::cbrt.
static inline float cube_root(float x) {
    const float near = std::bit_cast<float>(std::bit_cast<std::int32_t>(x) / 3 + 709921077);
    const float nearer = (2 * near + x / (near * near)) * (1.0F / 3);
    return (2 * nearer + x / (nearer * nearer)) * (1.0F / 3);
}
static inline double cube_root(double x) { return std::cbrt(x); }

/// e^x to 2e-7, and not below 1e-38: 2^n e^r with n whole and |r| <= ln 2 / 2, the second by its Taylor series. GCC
/// vectorises it, and not std::exp. A NaN stays one.
static inline float exponential(float x) {
    const float held = x < -87 ? -87 : (x > 88 ? 88 : x);
    const float n = std::floor(held * 1.44269504F + 0.5F);
    const float r = held - n * 0.693359375F + n * 2.12194440e-4F;
    const float series =
        1 + r * (1 + r * (0.5F + r * (1.0F / 6 + r * (1.0F / 24 + r * (1.0F / 120 + r * (1.0F / 720))))));
    const float whole = n == n ? n : 0;  // a NaN has no integer; it is in the series
    return series * std::bit_cast<float>((static_cast<std::int32_t>(whole) + 127) << 23);
}
static inline double exponential(double x) { return std::exp(x); }

}  // namespace waterlight

// By value and without references: GCC vectorises these, and not std::min.
#define WATERLIGHT_KERNEL_WORDS(T, VEC2, VEC3)                                  \
    using real = T;                                                             \
    using real2 = VEC2;                                                         \
    using real3 = VEC3;                                                         \
    using int2 = glm::ivec2;                                                    \
    using glm::cross;                                                           \
    using glm::dot;                                                             \
    KERNEL real min(real a, real b) { return a < b ? a : b; }                   \
    KERNEL real max(real a, real b) { return a > b ? a : b; }                   \
    KERNEL real clamp(real x, real lo, real hi) { return min(max(x, lo), hi); } \
    KERNEL real abs(real x) { return std::abs(x); }                             \
    KERNEL real sqrt(real x) { return std::sqrt(x); }                           \
    KERNEL real cbrt(real x) { return waterlight::cube_root(x); }               \
    KERNEL real exp(real x) { return waterlight::exponential(x); }              \
    KERNEL real pow(real x, real y) { return std::pow(x, y); }                  \
    KERNEL real floor(real x) { return std::floor(x); }                         \
    KERNEL real tanh(real x) { return std::tanh(x); }                           \
    KERNEL real sin(real x) { return std::sin(x); }                             \
    KERNEL real cos(real x) { return std::cos(x); }

namespace waterlight::f32 {
WATERLIGHT_KERNEL_WORDS(float, glm::vec2, glm::vec3)
}
namespace waterlight::f64 {
WATERLIGHT_KERNEL_WORDS(double, glm::dvec2, glm::dvec3)
}
