#include "sim/sines.hpp"

#include <cmath>
#include <numbers>

namespace waterlight {

namespace {
constexpr double radian = std::numbers::pi / 180;
}

glm::dvec2 wave_vector(const Sine& sine) {
    const double k = 2 * std::numbers::pi / sine.wavelength_m;
    const double direction = sine.direction_deg * radian;
    return {k * std::cos(direction), k * std::sin(direction)};
}

SurfacePoint evaluate(const Sine& sine, double omega, glm::dvec2 at_m, double time_s) {
    const glm::dvec2 k = wave_vector(sine);
    const double w = sine.frozen ? 0 : omega;
    const double phase = k.x * at_m.x + k.y * at_m.y - w * time_s + sine.phase_deg * radian;
    const double a_sin = sine.amplitude_m * std::sin(phase);
    return {sine.amplitude_m * std::cos(phase), -a_sin * k, w * a_sin};
}

glm::dvec2 wave_vector(const StandingWave& wave, const Grid& grid) {
    return {wave.half_waves_x * std::numbers::pi / grid.width_m(),
            wave.half_waves_y * std::numbers::pi / grid.height_m()};
}

SurfacePoint evaluate(const StandingWave& wave, const Grid& grid, double omega, glm::dvec2 at_m, double time_s) {
    const glm::dvec2 k = wave_vector(wave, grid);
    const glm::dvec2 phase{k.x * (at_m.x - grid.x0_m), k.y * (at_m.y - grid.y0_m)};
    const glm::dvec2 c{std::cos(phase.x), std::cos(phase.y)};
    const glm::dvec2 s{std::sin(phase.x), std::sin(phase.y)};
    const double a_cos = wave.amplitude_m * std::cos(omega * time_s);
    const double a_sin = wave.amplitude_m * std::sin(omega * time_s);
    return {a_cos * c.x * c.y, -a_cos * glm::dvec2(k.x * s.x * c.y, k.y * c.x * s.y), -omega * a_sin * c.x * c.y};
}

}  // namespace waterlight
