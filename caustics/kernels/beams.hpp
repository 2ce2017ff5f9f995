#pragma once

#include "sim/kernels/real.hpp"

namespace waterlight::f32 {
#include "caustics/kernels/beams.glsl"
#include "caustics/kernels/beams_along.glsl"
}  // namespace waterlight::f32
namespace waterlight::f64 {
#include "caustics/kernels/beams.glsl"
#include "caustics/kernels/beams_along.glsl"
}  // namespace waterlight::f64
