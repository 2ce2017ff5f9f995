// Directional wave spectra, modelled and measured.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "sim/water.hpp"

namespace waterlight {

enum class SpectrumType { pierson_moskowitz, jonswap, tma };

/// A modelled sea. Hs and Tp set the shape; directions spread as cos^2s((theta - mean)/2). Hs is that of the sea at the
/// water's depth: TMA is scaled after its depth factor (gravity waves only), so that Hs = 4 sqrt(m0) for every type.
struct SpectrumSettings {
    SpectrumType type = SpectrumType::jonswap;
    double significant_height_m = 1;  ///< Hs = 4 sqrt(m0) of the spectrum over all frequencies, > 0
    double peak_period_s = 5;         ///< > 0
    double peak_enhancement = 3.3;    ///< gamma of JONSWAP and TMA, >= 1
    double direction_deg = 0;         ///< towards, counter-clockwise from +x
    double spreading = 10;            ///< s >= 0
    std::uint64_t seed = 1;
};

/// A buoy's directional spectrum in NDBC's five files: STEM.data_spec, .swdir, .swdir2, .swr1, .swr2.
/// Density is linear in frequency between the bins' centres. Directions come from r1, r2, alpha1, alpha2 by the method
/// of maximum entropy of Lygre & Krogstad (1986), where missing from the nearest frequencies that have them.
/// With `tail`: beyond the last bin that stands clear of the file's quantum, S = beta f^-4 (Toba 1973), beta the mean
/// of f^4 S over the uppermost clear bins, but no more than Phillips' saturation 0.0081 g^2 (2 pi)^-4 f^-5 (Phillips
/// 1958; Pierson & Moskowitz 1964), up to the frequency of the slowest wave, where surface tension takes over from
/// gravity; its directions are those of the uppermost clear bins with directions. It is a model of a wind sea in
/// equilibrium: not of slicks, of a falling wind, nor of parasitic capillaries.
struct BuoySettings {
    std::filesystem::path stem;  ///< "ndbc/41010"; relative paths as resolved by the caller
    std::string time;            ///< "YYYY-MM-DD hh:mm"; empty takes the newest complete record
    bool tail = true;            ///< continue beyond the buoy's highest frequency
    std::uint64_t seed = 1;
};

/// S(f, theta) in m^2 / (Hz rad): variance density over frequency (Hz) and direction of travel (rad from +x).
struct DirectionalSpectrum {
    std::function<double(double f_hz, double theta_rad)> density;
    double f_min_hz = 0;      ///< no variance below
    double f_max_hz = 0;      ///< none above; infinity for a tail without end
    double variance_m2 = 0;   ///< m0 over all frequencies
    std::string description;  ///< model and its source, one line, for the report
};

/// Throws InputError where a setting is out of its range.
DirectionalSpectrum make_spectrum(const SpectrumSettings& settings, const Water& water);

/// Reads the five files. Throws InputError naming the file and what it lacks.
DirectionalSpectrum read_buoy(const BuoySettings& settings, const Water& water);

}  // namespace waterlight
