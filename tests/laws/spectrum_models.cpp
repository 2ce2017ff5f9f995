// The modelled spectra: their heights, shapes and directions.
#include <gtest/gtest.h>

#include "sim/error.hpp"
#include "sim/spectrum.hpp"
#include "tests/support/airy_runs.hpp"

namespace waterlight::testing {
namespace {

/// S(f), m^2/Hz: the integral over directions, exact for trigonometric polynomials.
double frequency_density(const DirectionalSpectrum& spectrum, double f) {
    constexpr int parts = 128;
    double sum = 0;
    for (int n = 0; n < parts; ++n) sum += spectrum.density(f, 2 * pi * n / parts);
    return sum * 2 * pi / parts;
}

/// m0 up to 40 peak frequencies, beyond which less than 1e-6 of it lies; the midpoint rule in log f.
double integrate(const DirectionalSpectrum& spectrum, double peak_hz) {
    constexpr int parts = 1500;
    const double step = std::log(100.0) / parts;
    double sum = 0;
    for (int n = 0; n < parts; ++n) {
        const double f = 0.4 * peak_hz * std::exp((n + 0.5) * step);
        sum += frequency_density(spectrum, f) * f * step;
    }
    return sum;
}

TEST(Spectrum, EveryTypeHasTheHeightAskedFor) {
    Water water;
    water.depth_m = 8;
    for (const auto type : {SpectrumType::pierson_moskowitz, SpectrumType::jonswap, SpectrumType::tma}) {
        for (const double enhancement : {1.0, 3.3, 7.0}) {
            const auto spectrum = make_spectrum({type, 1.7, 6, enhancement, 40, 6, 1}, water);
            EXPECT_NEAR(4 * std::sqrt(integrate(spectrum, 1.0 / 6)), 1.7, 1e-5);
            EXPECT_NEAR(4 * std::sqrt(spectrum.variance_m2), 1.7, 1e-12);
        }
    }
}

TEST(Spectrum, PiersonMoskowitzIsItsFormula) {
    const auto spectrum = make_spectrum({SpectrumType::pierson_moskowitz, 2, 8, 3.3, 0, 4, 1}, {});
    for (const double f : {0.08, 0.125, 0.2, 0.7}) {
        const double expected =
            0.3125 * 4 * std::pow(0.125, 4) * std::pow(f, -5) * std::exp(-1.25 * std::pow(0.125 / f, 4));
        EXPECT_NEAR(frequency_density(spectrum, f), expected, 1e-9 * expected);
    }
}

TEST(Spectrum, JonswapPeakStandsGammaAboveItsBase) {
    const auto sharp = make_spectrum({SpectrumType::jonswap, 1, 5, 3.3, 0, 10, 1}, {});
    const auto base = make_spectrum({SpectrumType::jonswap, 1, 5, 1, 0, 10, 1}, {});
    const double at_peak = frequency_density(sharp, 0.2) / frequency_density(base, 0.2);
    const double in_tail = frequency_density(sharp, 1.5) / frequency_density(base, 1.5);
    EXPECT_NEAR(at_peak / in_tail, 3.3, 1e-9);
}

TEST(Spectrum, TmaIsJonswapTimesTheDepthFactor) {
    Water water;
    water.depth_m = 5;
    const auto tma = make_spectrum({SpectrumType::tma, 1, 8, 3.3, 0, 10, 1}, water);
    const auto jonswap = make_spectrum({SpectrumType::jonswap, 1, 8, 3.3, 0, 10, 1}, water);
    // By its definition: (k^-3 dk/dw at depth h) / (k^-3 dk/dw in deep water).
    const auto factor = [](double f) {
        const double g = 9.81, w = 2 * pi * f, h = 5;
        const auto k_at = [&](double omega) {
            double k = omega * omega / g;
            for (int n = 0; n < 500; ++n) k = 0.5 * (k + omega * omega / (g * std::tanh(k * h)));
            return k;
        };
        const double slope = (k_at(w * (1 + 1e-5)) - k_at(w * (1 - 1e-5))) / (2e-5 * w);
        return std::pow(k_at(w), -3) * slope / (std::pow(w * w / g, -3) * 2 * w / g);
    };
    const double scale = frequency_density(tma, 2) / frequency_density(jonswap, 2);
    for (const double f : {0.08, 0.125, 0.2, 0.4})
        EXPECT_NEAR(frequency_density(tma, f) / frequency_density(jonswap, f) / scale, factor(f), 1e-6);
}

TEST(Spectrum, DirectionsPointWhereAskedWithTheSpreadOfTheirPower) {
    for (const double s : {0.0, 1.0, 10.0, 50.0}) {
        const auto spectrum = make_spectrum({SpectrumType::jonswap, 1, 5, 3.3, 130, s, 1}, {});
        std::complex<double> moment = 0;
        for (int n = 0; n < 720; ++n)
            moment += spectrum.density(0.25, n * pi / 360) * std::polar(pi / 360, n * pi / 360);
        moment /= frequency_density(spectrum, 0.25);
        // The first circular moment of cos^2s is s / (s + 1).
        EXPECT_NEAR(std::abs(moment - s / (s + 1) * std::polar(1.0, 130 * pi / 180)), 0, 1e-9);
    }
}

TEST(Spectrum, OutOfRangeIsRefused) {
    const auto refused = [](SpectrumSettings settings) { EXPECT_THROW(make_spectrum(settings, {}), InputError); };
    refused({.significant_height_m = 0});
    refused({.peak_period_s = -1});
    refused({.peak_enhancement = 0.5});
    refused({.direction_deg = std::nan("")});
    refused({.spreading = -1});
}

}  // namespace
}  // namespace waterlight::testing
