// Uneven ground as a camera sees it.
#pragma once

#include <functional>
#include <glm/vec2.hpp>

#include "caustics/camera.hpp"
#include "sim/field.hpp"

namespace waterlight {

/// Heights of the ground in the world of the beams.
struct PictureGround {
    std::function<double(glm::dvec2)> height_m;  ///< above still water, at any place; called from many threads
    double step_m = 0.1;                         ///< horizontal way on which the ground may be taken for even, > 0
    double highest_m = 0;                        ///< nowhere more
};

/// The t at which each pixel's ray eye + t r first meets the ground before `range_m`, else that of the range. A march
/// in steps of step_m, then bisection to a thousandth of a step.
Field<float> ground_reach(const Camera& camera, const PictureGround& ground, double range_m);

}  // namespace waterlight
