// Pierson & Moskowitz (1964), J. Geophys. Res. 69, 5181; JONSWAP: Hasselmann et al. (1973), Dtsch. Hydrogr. Z. A8(12);
// TMA: Bouws, Guenther, Rosenthal & Vincent (1985), J. Geophys. Res. 90, 975; spreading: Longuet-Higgins, Cartwright &
// Smith (1963), Ocean Wave Spectra, 111.
#include "sim/spectrum.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "sim/airy_dispersion.hpp"
#include "sim/error.hpp"
#include "sim/kernels/spectra.hpp"

namespace waterlight {

namespace {

constexpr double pi = std::numbers::pi;

void require(bool holds, const char* what, double found) {
    if (!holds) throw InputError(fmt::format("spectrum: {} (found {})", what, found));
}

void require_valid(const SpectrumSettings& settings) {
    const double height = settings.significant_height_m, period = settings.peak_period_s;
    require(height > 0 && std::isfinite(height), "significant_height_m must be above 0", height);
    require(period > 0 && std::isfinite(period), "peak_period_s must be above 0", period);
    require(settings.peak_enhancement >= 1 && settings.peak_enhancement <= 20, "peak_enhancement must be from 1 to 20",
            settings.peak_enhancement);
    require(std::isfinite(settings.direction_deg), "direction_deg must be a number", settings.direction_deg);
    require(settings.spreading >= 0 && settings.spreading <= 1000, "spreading must be from 0 to 1000",
            settings.spreading);
}

/// What the type multiplies Pierson and Moskowitz' shape with, at u peak frequencies.
double factor(const SpectrumSettings& settings, const Water& water, double u) {
    double product = 1;
    if (settings.type != SpectrumType::pierson_moskowitz) product *= f64::jonswap_peak(u, settings.peak_enhancement);
    const double omega = 2 * pi * u / settings.peak_period_s;
    // Beyond omega^2 h / g = 20 the factor is 1 to rounding.
    if (settings.type == SpectrumType::tma && omega * omega * water.depth_m < 20 * water.gravity_m_s2) {
        Water gravity_only = water;
        gravity_only.surface_tension_n_m = 0;
        product *= f64::tma_depth_factor(airy_wave_number(omega, gravity_only) * water.depth_m);
    }
    return product;
}

/// Integral over all u of Pierson and Moskowitz' shape times factor(), by the midpoint rule in its cumulative
/// distribution y = exp(-5/4 u^-4), in which the shape is 1 and the range [0, 1].
double integral(const SpectrumSettings& settings, const Water& water) {
    constexpr int parts = 20000;
    double sum = 0;
    for (int i = 0; i < parts; ++i)
        sum += factor(settings, water, std::pow(-std::log((i + 0.5) / parts) / 1.25, -0.25));
    return sum / parts;
}

/// cos^2s((theta - mean) / 2), of integral 1 over the circle.
double spreading(double theta, double mean, double s, double normaliser) {
    return normaliser * std::pow(std::abs(std::cos(0.5 * (theta - mean))), 2 * s);
}

std::string describe(const SpectrumSettings& settings) {
    const double hs = settings.significant_height_m, tp = settings.peak_period_s;
    const auto spread = fmt::format("cos^2s spreading, s = {:g}", settings.spreading);
    switch (settings.type) {
        case SpectrumType::pierson_moskowitz:
            return fmt::format("Pierson-Moskowitz (1964), Hs = {:g} m, Tp = {:g} s; {}", hs, tp, spread);
        case SpectrumType::jonswap:
            return fmt::format("JONSWAP (Hasselmann et al. 1973), Hs = {:g} m, Tp = {:g} s, gamma = {:g}; {}", hs, tp,
                               settings.peak_enhancement, spread);
        case SpectrumType::tma:
            break;
    }
    return fmt::format("TMA (Bouws et al. 1985), Hs = {:g} m at this depth, Tp = {:g} s, gamma = {:g}; {}", hs, tp,
                       settings.peak_enhancement, spread);
}

}  // namespace

DirectionalSpectrum make_spectrum(const SpectrumSettings& settings, const Water& water) {
    require_valid(settings);
    const double fp = 1 / settings.peak_period_s;
    const double m0 = settings.significant_height_m * settings.significant_height_m / 16;
    const double scale = m0 / (fp * integral(settings, water));
    const double mean = settings.direction_deg * pi / 180, s = settings.spreading;
    const double normaliser = std::exp(std::lgamma(s + 1) - std::lgamma(s + 0.5)) / (2 * std::sqrt(pi));

    DirectionalSpectrum spectrum;
    spectrum.density = [=](double f_hz, double theta_rad) {
        const double u = f_hz / fp;
        return scale * f64::pierson_moskowitz_shape(u) * factor(settings, water, u) *
               spreading(theta_rad, mean, s, normaliser);
    };
    spectrum.f_min_hz = 0.4 * fp;  // exp(-5/4 0.4^-4) = 6e-22
    spectrum.f_max_hz = std::numeric_limits<double>::infinity();
    spectrum.variance_m2 = m0;
    spectrum.description = describe(settings);
    return spectrum;
}

}  // namespace waterlight
