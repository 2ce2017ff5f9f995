// Sums of sines and standing waves, with their slopes: formulas for initial states and prescribed surfaces.
#pragma once

#include <glm/vec2.hpp>
#include <span>

#include "sim/grid.hpp"

namespace waterlight {

/// elevation = a cos(k.x - w t + phase). Travels along direction_deg (counter-clockwise from +x) with the speed that
/// the model gives it; stands still if frozen.
struct Sine {
    double amplitude_m = 0.01;
    double wavelength_m = 1;  ///< > 0
    double direction_deg = 0;
    double phase_deg = 0;
    bool frozen = false;
};

/// elevation = a cos(kx (x - x0)) cos(ky (y - y0)) cos(w t), with kx = half_waves_x pi / width, likewise y.
/// A periodic side takes even numbers of half waves only.
struct StandingWave {
    double amplitude_m = 0.01;
    int half_waves_x = 1;  ///< >= 0
    int half_waves_y = 0;  ///< >= 0
};

/// Elevation, slope and vertical velocity of a formula at one place and time.
struct SurfacePoint {
    double elevation_m = 0;
    glm::dvec2 slope{0, 0};
    double rate_m_s = 0;
};

/// wave vector k of the sine, rad/m.
glm::dvec2 wave_vector(const Sine& sine);

/// `omega` is the angular frequency that the model gives to this sine, rad/s (ignored when frozen).
SurfacePoint evaluate(const Sine& sine, double omega, glm::dvec2 at_m, double time_s);

/// wave vector (kx, ky) of the standing wave on `grid`, rad/m.
glm::dvec2 wave_vector(const StandingWave& wave, const Grid& grid);

/// `omega` as above.
SurfacePoint evaluate(const StandingWave& wave, const Grid& grid, double omega, glm::dvec2 at_m, double time_s);

}  // namespace waterlight
