#include "caustics/surface_point.hpp"

#include <algorithm>
#include <cmath>

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

double steepest_slope(const Surface& surface) {
    const Grid& g = surface.grid;
    const glm::dvec2 climb = surface.tilt * glm::dvec2{g.width_m(), g.height_m()};
    const bool round_x = surface.boundary.x == Side::periodic, round_y = surface.boundary.y == Side::periodic;
    glm::dvec2 steps{0, 0};
    for (int j = 0; j < g.ny; ++j) {
        const float* here = surface.elevation.row(j);
        const float* next = surface.elevation.row((j + 1) % g.ny);
        const bool last = j + 1 == g.ny;
        for (int i = 0; i + 1 < g.nx; ++i) steps.x = std::max<double>(steps.x, std::abs(here[i + 1] - here[i]));
        if (round_x) steps.x = std::max(steps.x, std::abs(here[0] + climb.x - here[g.nx - 1]));
        if (last && !round_y) continue;
        for (int i = 0; i < g.nx; ++i) steps.y = std::max(steps.y, std::abs(next[i] + (last ? climb.y : 0) - here[i]));
    }
    return std::hypot(steps.x / g.dx_m, steps.y / g.dy_m);
}

}  // namespace waterlight
