#pragma once

#include "sim/kernels/real.hpp"

namespace waterlight::f32 {
#include "caustics/kernels/surface_lookup.glsl"
}
namespace waterlight::f64 {
#include "caustics/kernels/surface_lookup.glsl"
}
