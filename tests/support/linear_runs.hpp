// Short ways to set up and read runs of the linear model.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/kernels/linear.hpp"
#include "sim/linear.hpp"

namespace waterlight::testing {

/// 1 m/s of wave speed on a basin of width by height metres.
inline LinearSettings basin(int nx, int ny, double width_m, double height_m, Boundary boundary) {
    LinearSettings settings;
    settings.grid = make_grid(nx, ny, width_m, height_m);
    settings.boundary = boundary;
    settings.water.gravity_m_s2 = 10;
    settings.water.depth_m = 0.1;
    return settings;
}

/// The frequency (rad/s) that the leapfrog scheme gives to a wave vector k (rad/m) at c = 1 m/s.
inline double leapfrog_frequency(glm::dvec2 k, const Grid& grid, double dt) {
    const double sin2 = f64::leapfrog_sin2(1, dt, f64::discrete_wave_number2(k.x, grid.dx_m),
                                           f64::discrete_wave_number2(k.y, grid.dy_m));
    return 2 * std::asin(std::sqrt(sin2)) / dt;
}

/// Largest difference between the model and `expected(x, y)`, m.
template <class Real, class Expected>
double largest_error(const LinearModel<Real>& model, const Grid& grid, const Expected& expected) {
    double worst = 0;
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            worst = std::max(worst, std::abs(model.elevation_m(i, j) - expected(grid.x_m(i), grid.y_m(j))));
        }
    }
    return worst;
}

/// Sum of the elevation over the cells, m.
template <class Real>
double sum_of_elevation(const LinearModel<Real>& model, const Grid& grid) {
    double sum = 0;
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) sum += model.elevation_m(i, j);
    }
    return sum;
}

}  // namespace waterlight::testing
