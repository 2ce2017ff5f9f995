#include <array>
#include <cmath>

#include "caustics/kernels/surface_lookup.hpp"
#include "caustics/truth.hpp"

namespace waterlight {

namespace {

/// Cubic Hermite basis and its derivative at t in [0, 1]: weights of value 0, value 1, slope 0, slope 1.
struct Hermite {
    std::array<double, 4> value;
    std::array<double, 4> derivative;
    explicit Hermite(double t)
        : value{(1 + 2 * t) * (1 - t) * (1 - t), t * t * (3 - 2 * t), t * (1 - t) * (1 - t), t * t * (t - 1)},
          derivative{6 * t * (t - 1), 6 * t * (1 - t), (1 - t) * (1 - 3 * t), t * (3 * t - 2)} {}
};

int continued_side(Side side) { return side == Side::periodic ? SIDE_PERIODIC : SIDE_WALL; }

/// A sampled surface continued beyond its sides, read cell by cell.
class Continued {
  public:
    explicit Continued(const Surface& s) : s_(s), climb_(s.tilt * glm::dvec2{s.grid.width_m(), s.grid.height_m()}) {}

    double elevation(int i, int j) const {
        const f64::AxisPlace x = place_x(i), y = place_y(j);
        return s_.elevation(x.low, y.low) + x.wraps_low * climb_.x + y.wraps_low * climb_.y;
    }
    double slope_x(int i, int j) const {
        const f64::AxisPlace x = place_x(i), y = place_y(j);
        return x.mirror_low * s_.slope_x(x.low, y.low);
    }
    double slope_y(int i, int j) const {
        const f64::AxisPlace x = place_x(i), y = place_y(j);
        return y.mirror_low * s_.slope_y(x.low, y.low);
    }
    /// d2 elevation / dx dy by central differences of both slopes.
    double twist(int i, int j) const {
        return 0.25 * ((slope_y(i + 1, j) - slope_y(i - 1, j)) / s_.grid.dx_m +
                       (slope_x(i, j + 1) - slope_x(i, j - 1)) / s_.grid.dy_m);
    }

  private:
    f64::AxisPlace place_x(int i) const {
        return f64::place_on_axis(i, 0, s_.grid.nx, continued_side(s_.boundary.x), 0.5);
    }
    f64::AxisPlace place_y(int j) const {
        return f64::place_on_axis(j, 0, s_.grid.ny, continued_side(s_.boundary.y), 0.5);
    }

    const Surface& s_;
    glm::dvec2 climb_;
};

SurfacePoint at(const Surface& s, glm::dvec2 p) {
    const Grid& g = s.grid;
    if (beyond(s.boundary.x, g.x0_m, g.width_m(), p.x) || beyond(s.boundary.y, g.y0_m, g.height_m(), p.y)) return {};
    const Continued c(s);
    const double u = (p.x - g.x_m(0)) / g.dx_m, v = (p.y - g.y_m(0)) / g.dy_m;
    const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
    const Hermite hx(u - i), hy(v - j);
    SurfacePoint out;
    for (int b = 0; b < 2; ++b) {
        for (int a = 0; a < 2; ++a) {
            const double f = c.elevation(i + a, j + b), fx = g.dx_m * c.slope_x(i + a, j + b);
            const double fy = g.dy_m * c.slope_y(i + a, j + b), fxy = g.dx_m * g.dy_m * c.twist(i + a, j + b);
            const auto sum = [&](const std::array<double, 4>& x, const std::array<double, 4>& y) {
                return y[b] * (x[a] * f + x[a + 2] * fx) + y[b + 2] * (x[a] * fy + x[a + 2] * fxy);
            };
            out.elevation_m += sum(hx.value, hy.value);
            out.slope.x += sum(hx.derivative, hy.value) / g.dx_m;
            out.slope.y += sum(hx.value, hy.derivative) / g.dy_m;
        }
    }
    return out;
}

}  // namespace

TruthSurface interpolate(const Surface& surface) {
    return {surface.grid, surface.boundary, [&surface](glm::dvec2 p) { return at(surface, p); }};
}

}  // namespace waterlight
