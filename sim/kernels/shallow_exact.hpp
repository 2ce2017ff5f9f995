#pragma once

#include "sim/kernels/real.hpp"

namespace waterlight::f64 {
#include "sim/kernels/shallow_exact.glsl"
}
