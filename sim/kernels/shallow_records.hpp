#pragma once

#include "sim/kernels/real.hpp"

namespace waterlight::f32 {
#include "sim/kernels/shallow_records.glsl"
}
namespace waterlight::f64 {
#include "sim/kernels/shallow_records.glsl"
}
