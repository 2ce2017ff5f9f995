#include "app/probe_spectrum.hpp"

#include <fftw3.h>

#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <numbers>
#include <numeric>
#include <vector>

namespace waterlight {

namespace {

double mean_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// |Fourier transform|^2 at frequencies 0 to half the sampling.
std::vector<double> power_of(std::vector<double> values) {
    const std::size_t n = values.size();
    std::vector<std::complex<double>> waves(n / 2 + 1);
    auto* out = reinterpret_cast<fftw_complex*>(waves.data());
    const std::unique_ptr<fftw_plan_s, decltype(&fftw_destroy_plan)> plan(
        fftw_plan_dft_r2c_1d(static_cast<int>(n), values.data(), out, FFTW_ESTIMATE), fftw_destroy_plan);
    fftw_execute(plan.get());
    std::vector<double> power;
    for (const std::complex<double>& wave : waves) power.push_back(std::norm(wave));
    return power;
}

}  // namespace

double significant_height(std::span<const double> elevation_m) {
    if (elevation_m.empty()) return std::numeric_limits<double>::quiet_NaN();
    const double mean = mean_of(elevation_m);
    double squares = 0;
    for (const double e : elevation_m) squares += (e - mean) * (e - mean);
    return 4 * std::sqrt(squares / static_cast<double>(elevation_m.size()));
}

double peak_period(std::span<const double> elevation_m, double every_s) {
    constexpr std::size_t least = 4;
    const std::size_t n = elevation_m.size();
    if (n < least) return std::numeric_limits<double>::quiet_NaN();
    const double mean = mean_of(elevation_m), turn = 2 * std::numbers::pi / static_cast<double>(n);
    std::vector<double> windowed;
    for (std::size_t i = 0; i < n; ++i)
        windowed.push_back((elevation_m[i] - mean) * (0.5 - 0.5 * std::cos(turn * static_cast<double>(i))));
    const std::vector<double> power = power_of(std::move(windowed));
    double most = 0, weights = 0, moments = 0;
    for (std::size_t i = 1; i < power.size(); ++i) most = std::max(most, power[i]);
    for (std::size_t i = 1; i < power.size() && most > 0; ++i) {
        const double weight = std::pow(power[i] / most, 4);
        weights += weight;
        moments += weight * static_cast<double>(i) / (static_cast<double>(n) * every_s);
    }
    return weights > 0 ? weights / moments : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace waterlight
