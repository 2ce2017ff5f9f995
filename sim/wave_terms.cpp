#include "sim/wave_terms.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/airy_dispersion.hpp"

namespace waterlight {

namespace {

constexpr double pi = std::numbers::pi;

/// tanh(k h), at least what keeps a division by its powers finite.
double depth_tanh(double k, const Water& water) { return std::max(std::tanh(k * water.depth_m), 1e-6); }

/// Amplitude of harmonic m over that of the sine it grows from, at the steepening sigma: Fubini's to the breaking of
/// the front, Fay's sawtooth from where both agree.
double steepened_harmonic(int m, double sigma) {
    if (sigma < 1e-9) return m == 1 ? 1 : 0;
    if (sigma <= 1) return 2 * std::cyl_bessel_j(m, m * sigma) / (m * sigma);
    return 2 / (m * (1 + sigma));
}

}  // namespace

double shift_error(double wavelengths) {
    const double w = std::min(std::abs(wavelengths), 0.5);
    return std::sin(pi * w) / pi;
}

double long_wave_excess(double k, const Water& water) {
    const double airy = airy_omega(k, water) / k;
    return std::sqrt(water.gravity_m_s2 * water.depth_m) / airy - 1;
}

double amplitude_excess(double k, double a, const Water& water) {
    const double t = depth_tanh(k, water), t2 = t * t;
    return k * a * k * a * (9 - 10 * t2 + 9 * t2 * t2) / (16 * t2 * t2);
}

double standing_excess(double k, double a, const Water& water) {
    const double t = depth_tanh(k, water);
    return k * a * k * a * (9 / (t * t * t * t) - 12 / (t * t) - 3 - 2 * t * t) / 64;
}

double bound_harmonic(double k, double a, const Water& water) {
    const double t = depth_tanh(k, water);
    return k * a * (3 - t * t) / (4 * t * t * t);
}

double harmonic_growth(double k, double wavelengths, const Water& water) {
    const double half_phase = pi * wavelengths * std::abs(2 - airy_omega(2 * k, water) / airy_omega(k, water));
    return half_phase < pi / 4 ? 2 * std::sin(half_phase) : std::numbers::sqrt2;
}

double linear_error(const WaveTrain& wave, double speed_excess, const Water& water) {
    const double k = wave.wave_number, a = wave.amplitude_m, n = wave.wavelengths;
    const double growth = harmonic_growth(k, n, water);
    const double settled = 0.5 * growth * growth;
    const double excess = wave.stands ? standing_excess(k, a, water) : amplitude_excess(k, a, water);
    // Two waves of half the amplitude make a standing one.
    const double harmonic = bound_harmonic(k, wave.stands ? 0.5 * a : a, water) * growth;
    return std::min(std::hypot(shift_error(n * (speed_excess - settled * excess)), harmonic / (2 * pi)), largest_shift);
}

double steepening(const WaveTrain& wave, const Water& water) {
    const double a = wave.stands ? 0.5 * wave.amplitude_m : wave.amplitude_m;
    return 1.5 * a / water.depth_m * 2 * pi * wave.wavelengths;
}

double shallow_error(const WaveTrain& wave, const Water& water) {
    constexpr int harmonics = 10;
    const double sigma = steepening(wave, water);
    double sum = 0;
    for (int m = 1; m <= harmonics; ++m) {
        const double misplaced = m * wave.wavelengths * long_wave_excess(m * wave.wave_number, water);
        // What a sawtooth loses of its first harmonic is lost by the model alone, where dispersion counts.
        const double error = (m == 1 ? 1 : steepened_harmonic(m, sigma)) * shift_error(misplaced);
        sum += error * error;
    }
    return std::min(std::sqrt(sum), largest_shift);
}

double breaking_ratio(const WaveTrain& wave, const Water& water) {
    return wave.wave_number * wave.amplitude_m / (0.44 * depth_tanh(wave.wave_number, water));
}

double froude_number(const WaveTrain& wave, const Water& water) { return wave.amplitude_m / water.depth_m; }

double leapfrog_lag(double k, double dx, double courant) {
    if (k * dx >= pi) return 1;
    const double seen = courant * std::sin(0.5 * k * dx);
    return 1 - std::asin(seen) / (0.5 * courant * k * dx);
}

double finite_volume_error(double k, double dx, double wavelengths) {
    const double lost = 2 * pi * 0.19 * std::pow(wavelengths, 0.75) * k * dx * k * dx;
    return (1 - std::exp(-lost)) / (2 * pi);
}

}  // namespace waterlight
