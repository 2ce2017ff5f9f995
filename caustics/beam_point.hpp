// Irradiance at a place in the water, from the beams that pass it.
#pragma once

#include <glm/vec3.hpp>

#include "caustics/beams.hpp"

namespace waterlight {

struct PointIrradiance {
    double plane_w_m2 = 0;   ///< downward, on the horizontal plane
    double scalar_w_m2 = 0;  ///< on planes that face each beam, summed
    int beams = 0;           ///< that pass: more than one past a focus
};

/// Sums flux over section area of every beam whose section through the place, parallel to its triangle on the surface,
/// holds it: the paper's area polynomial in beam space. Dark above the surface, in the ground, behind objects and
/// beyond a wall. Unscattered light only.
PointIrradiance irradiance_at(const Beams& beams, glm::dvec3 place_m);

}  // namespace waterlight
