#pragma once

#include "caustics/kernels/optics.hpp"

namespace waterlight::f32 {
#include "caustics/kernels/splat.glsl"
}
namespace waterlight::f64 {
#include "caustics/kernels/splat.glsl"
}
