// Surfaces given by a formula or by files: no dynamics.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "sim/sines.hpp"
#include "sim/water.hpp"
#include "sim/wave_model.hpp"

namespace waterlight {

/// A random sea of trochoidal (Gerstner) waves. Seeded directions, lengths and phases; steepness k a summed over all
/// waves stays below 1, so that the surface is a height field.
struct GerstnerSettings {
    int waves = 16;                   ///< >= 1
    glm::dvec2 wavelength_m{0.5, 4};  ///< shortest and longest; > 0
    double steepness = 0.4;           ///< sum of k a over the waves, in [0, 1)
    double direction_deg = 0;         ///< mean direction of travel
    double spread_deg = 30;           ///< directions are drawn within +- this
    std::uint64_t seed = 1;
};

struct PrescribedSettings {
    Grid grid;
    Boundary boundary;
    Water water;
    glm::dvec2 slope{0, 0};   ///< a tilt about the origin, added
    std::vector<Sine> sines;  ///< they travel with the speed of Airy waves and need not fit periodic sides
    std::optional<GerstnerSettings> gerstner;  ///< moved to the nearest waves that fit periodic sides
    /// Instead of sines and Gerstner waves: .vti, or a .pvd series, linear in time between its files and still before
    /// the first and after the last; array "elevation", resampled bilinearly; slopes by central differences.
    std::optional<std::filesystem::path> file;
};

/// A surface known at any place and time in double precision.
class SurfaceFormula {
  public:
    virtual ~SurfaceFormula() = default;
    virtual SurfacePoint at(glm::dvec2 at_m, double time_s) const = 0;
};

/// The prescribed model; formula() is what the truth is computed from.
class PrescribedModel : public WaveModel {
  public:
    /// The exact surface where there is no file; otherwise null.
    virtual const SurfaceFormula* formula() const = 0;
};

/// Throws InputError where a setting is out of its range or a file cannot be read (naming file and array).
std::unique_ptr<PrescribedModel> make_prescribed(const PrescribedSettings& settings);

}  // namespace waterlight
