// Short ways to set up and read runs of the airy model.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "sim/airy.hpp"

namespace waterlight::testing {

using std::numbers::pi;

/// The dispersion relation in full, as textbooks give it (Lamb, Hydrodynamics, 267).
inline double textbook_omega(double k, const Water& water) {
    const double tension = water.surface_tension_n_m / water.density_kg_m3;
    return std::sqrt((water.gravity_m_s2 * k + tension * k * k * k) * std::tanh(k * water.depth_m));
}

inline AirySettings tank(int nx, int ny, double width_m, double height_m, Boundary boundary, double depth_m) {
    AirySettings settings;
    settings.grid = make_grid(nx, ny, width_m, height_m);
    settings.boundary = boundary;
    settings.water.depth_m = depth_m;
    return settings;
}

/// Twice the mean over the cells of elevation exp(-i k.x): the amplitude and phase of a plane wave.
inline std::complex<double> plane_wave_in(const Surface& surface, glm::dvec2 k) {
    std::complex<double> sum = 0;
    const Grid& grid = surface.grid;
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i)
            sum += static_cast<double>(surface.elevation(i, j)) *
                   std::polar(1.0, -(k.x * grid.x_m(i) + k.y * grid.y_m(j)));
    return 2.0 * sum / static_cast<double>(grid.cells());
}

inline double sum_of(const Field<float>& field) {
    double sum = 0;
    for (const float value : field.values()) sum += value;
    return sum;
}

inline double rms_of(const Field<float>& field) {
    double sum = 0;
    for (const float value : field.values()) sum += static_cast<double>(value) * value;
    return std::sqrt(sum / static_cast<double>(field.size()));
}

inline double largest_difference(const Field<float>& a, const Field<float>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(static_cast<double>(a.data()[i]) - b.data()[i]));
    return largest;
}

/// Largest difference of a field of `grid` from expected(x, y).
template <class Expected>
double largest_error(const Field<float>& field, const Grid& grid, const Expected& expected) {
    double largest = 0;
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i)
            largest = std::max<double>(largest, std::abs(field(i, j) - expected(grid.x_m(i), grid.y_m(j))));
    return largest;
}

}  // namespace waterlight::testing
