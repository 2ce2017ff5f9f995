#pragma once

#include "sim/boundary.hpp"
#include "sim/kernels/real.hpp"

namespace waterlight::f32 {
#include "caustics/kernels/surface_lookup.glsl"
}
namespace waterlight::f64 {
#include "caustics/kernels/surface_lookup.glsl"
}

namespace waterlight {

/// The SIDE_ number by which a kernel text knows a side.
inline int side_number(Side side) {
    switch (side) {
        case Side::periodic:
            return SIDE_PERIODIC;
        case Side::wall:
            return SIDE_WALL;
        case Side::absorbing:
            break;
    }
    return SIDE_ABSORBING;
}

}  // namespace waterlight
