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

}  // namespace waterlight
