#pragma once

#include "sim/kernels/real.hpp"

namespace waterlight::f32 {
#include "caustics/kernels/cell_share.glsl"
}
namespace waterlight::f64 {
#include "caustics/kernels/cell_share.glsl"
}
