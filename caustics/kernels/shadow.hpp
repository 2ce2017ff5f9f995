#pragma once

#include "sim/kernels/real.hpp"

namespace waterlight::f32 {
#include "caustics/kernels/shadow.glsl"
}
namespace waterlight::f64 {
#include "caustics/kernels/shadow.glsl"
}
