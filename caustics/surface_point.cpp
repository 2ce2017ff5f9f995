#include "caustics/surface_point.hpp"

#include "caustics/axis_place.hpp"

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

SurfacePoint surface_point(const Surface& surface, glm::dvec2 at_m) {
    const Grid& g = surface.grid;
    const glm::dvec2 climb = surface.tilt * glm::dvec2{g.width_m(), g.height_m()};
    const f64::AxisPlace x = axis_place(at_m.x, g.x_m(0), g.dx_m, g.nx, surface.boundary.x);
    const f64::AxisPlace y = axis_place(at_m.y, g.y_m(0), g.dy_m, g.ny, surface.boundary.y);
    const double water = x.water * y.water;
    const double climbed = f64::wraps_between(x) * climb.x + f64::wraps_between(y) * climb.y;
    return {
        water * (mix(surface.elevation, x, y) + climbed),
        water * glm::dvec2{mix(surface.slope_x, x, y, x.mirror_low, x.mirror_high), mix_rows(surface.slope_y, x, y)},
        0};
}

}  // namespace waterlight
