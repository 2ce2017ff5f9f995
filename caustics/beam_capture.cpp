#include "caustics/beam_capture.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "caustics/first_crossing.hpp"
#include "caustics/surface_point.hpp"

namespace waterlight {

SurfaceCapture::SurfaceCapture(const Surface& surface, glm::dvec3 sun_direction, double reach_m)
    : surface_(surface), slant_(glm::dvec2(sun_direction) / sun_direction.z) {
    float low = 0, high = 0;
    for (const float e : surface.elevation.values()) {
        low = std::min(low, e);
        high = std::max(high, e);
    }
    const double slant = glm::length(slant_);
    const double beyond = glm::length(surface.tilt) * (reach_m + 2 * slant * (high - low));
    low_ = low - beyond;
    high_ = high + beyond;
    const double cells = slant * (high_ - low_) / std::min(surface.grid.dx_m, surface.grid.dy_m);
    steps_ = std::clamp(static_cast<int>(std::ceil(cells)), 1, 256);
}

glm::dvec2 SurfaceCapture::hold(glm::dvec2 at_m) const {
    const Grid& g = surface_.grid;
    if (surface_.boundary.x == Side::wall) at_m.x = std::clamp(at_m.x, g.x0_m, g.x0_m + g.width_m());
    if (surface_.boundary.y == Side::wall) at_m.y = std::clamp(at_m.y, g.y0_m, g.y0_m + g.height_m());
    return at_m;
}

/// Height at which the ray first meets the surface.
double SurfaceCapture::meet(glm::dvec2 at_m) const {
    return first_crossing({high_, low_, steps_},
                          [&](double z) { return z - surface_point(surface_, hold(at_m + z * slant_)).elevation_m; });
}

CapturedPoint SurfaceCapture::capture(glm::dvec2 at_m) const {
    if (slant_ != glm::dvec2{0, 0} && low_ < high_) at_m += meet(at_m) * slant_;
    at_m = hold(at_m);
    const SurfacePoint p = surface_point(surface_, at_m);
    return {{at_m, p.elevation_m}, p.slope};
}

}  // namespace waterlight
