#pragma once

#include "sim/kernels/real.hpp"

namespace waterlight::f32 {
KERNEL int floatBitsToInt(float x) { return std::bit_cast<std::int32_t>(x); }
#include "caustics/kernels/phase_table.glsl"
}  // namespace waterlight::f32
