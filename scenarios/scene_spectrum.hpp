// The waves that a scenario will make, known before it is run: from its sines, standing waves, sources, sea and
// inflows.
#pragma once

#include <vector>

#include "scenarios/scenario.hpp"
#include "sim/wave_terms.hpp"

namespace waterlight {

/// Waves of about one length.
struct SceneWave {
    WaveTrain train;         ///< its amplitude counts all waves of the same source within half an octave
    double variance_m2 = 0;  ///< of the elevation, over the domain
};

/// What a shallow-water run is to show beside waves: the error of its grid is factor (dx / length)^order, as measured
/// by RMS(difference) / (2 pi RMS(elevation)) on exact solutions (docs/auto.md).
struct Feature {
    double length_m = 0;
    double factor = 0;
    double order = 1;
};
constexpr Feature bore_over(double length_m) { return {length_m, 0.078, 0.5}; }
constexpr Feature dry_front_over(double length_m) { return {length_m, 0.1, 0.8}; }
constexpr Feature shore_over(double length_m) { return {length_m, 0.095, 1.55}; }
constexpr Feature vortex_over(double length_m) { return {length_m, 1.9, 2.7}; }

struct SceneSpectrum {
    std::vector<SceneWave> waves;
    std::vector<Feature> features;
    bool bores = false;  ///< it starts from a jump, or from a state that is exact in shallow water only
    double jump_m = 0;   ///< the highest step that it starts from

    double variance_m2() const;
    /// Of the largest crests, m: that of one wave, or twice the root mean square of many.
    double amplitude_m() const;
    /// Root of the mean square of the slope.
    double rms_slope() const;
};

/// Waves that leave through absorbing sides travel no farther than across the domain. Reads a buoy's and an inflow's
/// files, whose paths must hold. Throws InputError where they cannot be used.
SceneSpectrum scene_spectrum(const Scenario& scenario);

}  // namespace waterlight
