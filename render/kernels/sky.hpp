#pragma once

#include "sim/kernels/real.hpp"

namespace waterlight::f32 {
KERNEL real acos(real x) { return std::acos(x); }
#include "render/kernels/sky.glsl"
}  // namespace waterlight::f32
namespace waterlight::f64 {
KERNEL real acos(real x) { return std::acos(x); }
#include "render/kernels/sky.glsl"
}  // namespace waterlight::f64
