#include "sim/linear_initial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/error.hpp"
#include "sim/kernels/linear.hpp"

namespace waterlight {

namespace {

void require(bool holds, const std::string& what) {
    if (!holds) throw InputError("linear: " + what);
}

// The discrete frequency w of `sine` enters its rate as sin(w dt) / dt, since eta(n+1) - eta(n-1) = 2 a sin(w dt)
// sin(phase).
double rate_frequency(const Sine& sine, const LinearSettings& settings, double dt) {
    const glm::dvec2 k = wave_vector(sine);
    const double speed = f64::long_wave_speed(settings.water.gravity_m_s2, settings.water.depth_m);
    const double sin2 = f64::leapfrog_sin2(speed, dt, f64::discrete_wave_number2(k.x, settings.grid.dx_m),
                                           f64::discrete_wave_number2(k.y, settings.grid.dy_m));
    const double half_angle = std::asin(std::sqrt(std::min(sin2, 1.0)));
    return std::sin(2 * half_angle) / dt;
}

}  // namespace

void check_linear(const LinearSettings& settings) {
    const Grid& grid = settings.grid;
    const Water& water = settings.water;
    require(grid.nx >= 1 && grid.ny >= 1, "the grid needs at least one cell each way");
    require(grid.dx_m > 0 && grid.dy_m > 0, "cells must be larger than 0");
    require(water.depth_m > 0 && std::isfinite(water.depth_m), "the depth must be above 0 and finite");
    require(water.gravity_m_s2 > 0, "gravity must be above 0");
    require(settings.cfl > 0 && settings.cfl <= 1, fmt::format("cfl is {}, allowed is (0, 1]", settings.cfl));
    require(settings.sponge_m >= 0, "the width of the sponge must be 0 or more");
    for (const Sine& sine : settings.sines) require(sine.wavelength_m > 0, "a sine's wavelength must be above 0");
    const auto fits = [](int half_waves, Side side) {
        return half_waves >= 0 && (side != Side::periodic || half_waves % 2 == 0);
    };
    for (const StandingWave& wave : settings.standing) {
        require(fits(wave.half_waves_x, settings.boundary.x) && fits(wave.half_waves_y, settings.boundary.y),
                "half waves must be 0 or more, and even between periodic sides");
    }
    for (const Source& source : settings.sources) require_valid(source);
}

template <class Real>
void set_linear_elevation(const LinearSettings& settings, const Grid& grid, PaddedRows<Real>& elevation) {
    for (int j = 0; j < grid.ny; ++j) {
        Real* eta = elevation.row(j);
        for (int i = 0; i < grid.nx; ++i) {
            const glm::dvec2 at{grid.x_m(i), grid.y_m(j)};
            double sum = 0;
            for (const Sine& sine : settings.sines) sum += evaluate(sine, 0, at, 0).elevation_m;
            for (const StandingWave& wave : settings.standing) {
                sum += evaluate(wave, settings.grid, 0, at, 0).elevation_m;
            }
            eta[i] = static_cast<Real>(sum);
        }
        set_ghosts(eta, grid.nx, settings.boundary.x);
    }
}

template <class Real>
void set_linear_rate(const LinearSettings& settings, const Grid& grid, double dt_s, PaddedRows<Real>& rate) {
    std::vector<double> frequency;
    for (const Sine& sine : settings.sines) frequency.push_back(rate_frequency(sine, settings, dt_s));
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            const glm::dvec2 at{grid.x_m(i), grid.y_m(j)};
            double sum = 0;
            for (std::size_t n = 0; n < frequency.size(); ++n) {
                sum += evaluate(settings.sines[n], frequency[n], at, 0).rate_m_s;
            }
            rate.row(j)[i] = static_cast<Real>(sum);
        }
    }
}

template void set_linear_elevation(const LinearSettings&, const Grid&, PaddedRows<float>&);
template void set_linear_elevation(const LinearSettings&, const Grid&, PaddedRows<double>&);
template void set_linear_rate(const LinearSettings&, const Grid&, double, PaddedRows<float>&);
template void set_linear_rate(const LinearSettings&, const Grid&, double, PaddedRows<double>&);

}  // namespace waterlight
