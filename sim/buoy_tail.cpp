#include "sim/buoy_tail.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/airy_dispersion.hpp"
#include "sim/error.hpp"
#include "sim/kernels/spectra.hpp"

namespace waterlight {

namespace {

constexpr double clear_quanta = 4;
constexpr int fitted_bins = 5;

/// The smallest density above zero.
double quantum(const std::vector<double>& density) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const double s : density)
        if (s > 0) smallest = std::min(smallest, s);
    return smallest;
}

/// Frequency of the wave of lowest phase speed, k = sqrt(g rho / sigma).
double slowest_wave_hz(const Water& water) {
    if (water.surface_tension_n_m <= 0) return std::numeric_limits<double>::infinity();
    const double k = std::sqrt(water.gravity_m_s2 * water.density_kg_m3 / water.surface_tension_n_m);
    return airy_omega(k, water) / (2 * std::numbers::pi);
}

}  // namespace

double BuoyTail::density(double f_hz) const {
    const double f2 = f_hz * f_hz;
    return std::min(beta / (f2 * f2), f64::phillips_saturation(f_hz, gravity_m_s2));
}

double BuoyTail::variance_m2() const {
    // Toba's range up to where it meets saturation, then Phillips'.
    const double saturation = f64::phillips_saturation(1, gravity_m_s2);
    const double meet = std::clamp(saturation / beta, begin_hz, end_hz);
    const double toba = beta / 3 * (std::pow(begin_hz, -3) - std::pow(meet, -3));
    return toba + saturation / 4 * (std::pow(meet, -4) - std::pow(end_hz, -4));
}

BuoyTail fit_tail(const std::vector<double>& frequency_hz, const std::vector<double>& density, const Water& water) {
    const double clear = clear_quanta * quantum(density);
    const auto last = std::find_if(density.rbegin(), density.rend(), [&](double s) { return s >= clear; });
    if (last == density.rend())
        throw InputError("no density stands clear of the file's rounding: there is no tail to fit");
    BuoyTail tail;
    tail.gravity_m_s2 = water.gravity_m_s2;
    tail.last_clear = static_cast<int>(std::distance(last, density.rend())) - 1;
    const int peak = static_cast<int>(std::max_element(density.begin(), density.end()) - density.begin());
    tail.first_fitted = std::max(tail.last_clear - fitted_bins + 1, std::min(peak + 1, tail.last_clear));
    double sum = 0;
    for (int i = tail.first_fitted; i <= tail.last_clear; ++i) sum += std::pow(frequency_hz[i], 4) * density[i];
    tail.beta = sum / (tail.last_clear - tail.first_fitted + 1);
    const std::size_t next = static_cast<std::size_t>(tail.last_clear) + 1;
    const double end = frequency_hz.back(), width = end - frequency_hz[frequency_hz.size() - 2];
    tail.begin_hz = next < frequency_hz.size() ? frequency_hz[next] : end + width;
    tail.end_hz = std::max(slowest_wave_hz(water), tail.begin_hz);
    return tail;
}

}  // namespace waterlight
