#pragma once

#include "caustics/kernels/optics.hpp"

namespace waterlight::f32 {
#include "caustics/kernels/floor.glsl"
#include "caustics/kernels/footprint.glsl"
}  // namespace waterlight::f32
namespace waterlight::f64 {
#include "caustics/kernels/floor.glsl"
#include "caustics/kernels/footprint.glsl"
}  // namespace waterlight::f64
