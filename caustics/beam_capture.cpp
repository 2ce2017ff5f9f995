#include "caustics/beam_capture.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "caustics/kernels/surface_lookup.hpp"

namespace waterlight {

namespace {

f64::AxisPlace place(double at, double first, double pitch, int n, int side) {
    const double cell = (at - first) / pitch, whole = std::floor(cell);
    return f64::place_on_axis(static_cast<int>(whole), cell - whole, n, side, 0.5);
}

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
    const f64::AxisPlace x = place(at_m.x, g.x_m(0), g.dx_m, g.nx, side_number(surface_.boundary.x));
    const f64::AxisPlace y = place(at_m.y, g.y_m(0), g.dy_m, g.ny, side_number(surface_.boundary.y));
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

/// Height at which the ray first meets the surface: steps down to below it, then by the Illinois method.
double SurfaceCapture::meet(glm::dvec2 at_m) const {
    const auto above = [&](double z) { return z - surface_at(hold(at_m + z * slant_)).elevation_m; };
    double z1 = high_, f1 = above(z1), z0 = z1, f0 = f1;
    for (int k = 1; k <= steps_ && f1 > 0; ++k) {
        z0 = z1;
        f0 = f1;
        z1 = high_ + (low_ - high_) * k / steps_;
        f1 = above(z1);
    }
    if (f0 <= 0) return z0;
    constexpr double enough_m = 1e-9;
    for (int k = 0; k < 40 && std::abs(z1 - z0) > enough_m && f1 != 0; ++k) {
        const double z = z1 - f1 * (z1 - z0) / (f1 - f0), f = above(z);
        if (f * f1 < 0) {
            z0 = z1;
            f0 = f1;
        } else {
            f0 *= 0.5;
        }
        z1 = z;
        f1 = f;
    }
    return z1;
}

CapturedPoint SurfaceCapture::capture(glm::dvec2 at_m) const {
    if (slant_ != glm::dvec2{0, 0} && low_ < high_) at_m += meet(at_m) * slant_;
    at_m = hold(at_m);
    const SurfacePoint p = surface_at(at_m);
    return {{at_m, p.elevation_m}, p.slope};
}

}  // namespace waterlight
