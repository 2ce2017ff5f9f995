#include "caustics/beam_capture.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "caustics/axis_place.hpp"
#include "caustics/first_crossing.hpp"

namespace waterlight {

namespace {

double mix(const Field<float>& f, const f64::AxisPlace& x, const f64::AxisPlace& y, double low = 1, double high = 1) {
    // `low` and `high` mirror the two columns.
    return f64::bilinear(low * f(x.low, y.low), high * f(x.high, y.low), low * f(x.low, y.high),
                         high * f(x.high, y.high), x.weight, y.weight);
}

/// mix() with the two rows mirrored.
double mix_rows(const Field<float>& f, const f64::AxisPlace& x, const f64::AxisPlace& y) {
    return f64::bilinear(y.mirror_low * f(x.low, y.low), y.mirror_low * f(x.high, y.low),
                         y.mirror_high * f(x.low, y.high), y.mirror_high * f(x.high, y.high), x.weight, y.weight);
}

}  // namespace

SurfaceCapture::SurfaceCapture(const Surface& surface, glm::dvec3 sun_direction, double reach_m)
    : surface_(surface),
      slant_(glm::dvec2(sun_direction) / sun_direction.z),
      climb_(surface.tilt * glm::dvec2{surface.grid.width_m(), surface.grid.height_m()}) {
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

SurfacePoint SurfaceCapture::surface_at(glm::dvec2 at_m) const {
    const Grid& g = surface_.grid;
    const f64::AxisPlace x = axis_place(at_m.x, g.x_m(0), g.dx_m, g.nx, surface_.boundary.x);
    const f64::AxisPlace y = axis_place(at_m.y, g.y_m(0), g.dy_m, g.ny, surface_.boundary.y);
    const double water = x.water * y.water;
    const double climb = f64::wraps_between(x) * climb_.x + f64::wraps_between(y) * climb_.y;
    return {
        water * (mix(surface_.elevation, x, y) + climb),
        water * glm::dvec2{mix(surface_.slope_x, x, y, x.mirror_low, x.mirror_high), mix_rows(surface_.slope_y, x, y)},
        0};
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
                          [&](double z) { return z - surface_at(hold(at_m + z * slant_)).elevation_m; });
}

CapturedPoint SurfaceCapture::capture(glm::dvec2 at_m) const {
    if (slant_ != glm::dvec2{0, 0} && low_ < high_) at_m += meet(at_m) * slant_;
    at_m = hold(at_m);
    const SurfacePoint p = surface_at(at_m);
    return {{at_m, p.elevation_m}, p.slope};
}

}  // namespace waterlight
