#pragma once

#include "sim/kernels/real.hpp"

namespace waterlight::f32 {
#include "render/kernels/finish.glsl"
}  // namespace waterlight::f32
namespace waterlight::f64 {
#include "render/kernels/finish.glsl"
}  // namespace waterlight::f64
