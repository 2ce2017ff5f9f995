#pragma once

#include "caustics/kernels/interface.hpp"

namespace waterlight::f32 {
#include "render/kernels/view_ray.glsl"
}  // namespace waterlight::f32
namespace waterlight::f64 {
#include "render/kernels/view_ray.glsl"
}  // namespace waterlight::f64
