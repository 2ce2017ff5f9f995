// A place among the cells along one axis, for kernels/surface_lookup.glsl.
#pragma once

#include <cmath>

#include "caustics/kernels/surface_lookup.hpp"
#include "sim/boundary.hpp"

namespace waterlight {

/// Of `at` (m) among n cells, `pitch` wide, whose first centre lies at `first`.
inline f64::AxisPlace axis_place(double at, double first, double pitch, int n, Side side) {
    const double cell = (at - first) / pitch, whole = std::floor(cell);
    return f64::place_on_axis(static_cast<int>(whole), cell - whole, n, side_number(side), 0.5);
}

}  // namespace waterlight
