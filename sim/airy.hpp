// Linear waves with full dispersion, exact in time, by their spectrum.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/sines.hpp"
#include "sim/sources.hpp"
#include "sim/spectrum.hpp"
#include "sim/water.hpp"
#include "sim/wave_model.hpp"

namespace waterlight {

/// A sea to start from: random phases from the seed, amplitudes from the spectrum.
struct Sea {
    DirectionalSpectrum spectrum;
    std::uint64_t seed = 1;
};

struct AirySettings {
    Grid grid;
    Boundary boundary;
    Water water;
    double margin_m = 0;      ///< hidden damped margin beyond each absorbing side; 0: a quarter of the domain
    std::vector<Sine> sines;  ///< initial state
    std::vector<StandingWave> standing;  ///< initial state
    std::optional<Sea> sea;              ///< initial state; periodic sides only
    std::vector<Source> sources;
};

/// What part of a sea's variance a grid can carry.
struct SeaCoverage {
    double variance_m2 = 0;       ///< of the spectrum
    double longer_fraction = 0;   ///< left out: waves longer than the domain
    double shorter_fraction = 0;  ///< left out: waves shorter than two cells
};

/// The airy model, which also says how much of its sea it carries. Its energy is that of the whole tank, the margins
/// beyond absorbing sides included. Without absorbing sides any step is exact; with them it is divided.
class AiryModel : public WaveModel {
  public:
    virtual SeaCoverage sea_coverage() const = 0;
};

/// Throws InputError where a setting is out of its range or a combination is not supported.
std::unique_ptr<AiryModel> make_airy(const AirySettings& settings);

}  // namespace waterlight
