// A random sea of trochoidal waves, seen as a height field.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "sim/kernels/gerstner.hpp"
#include "sim/prescribed.hpp"

namespace waterlight {

/// One trochoidal wave.
struct GerstnerWave {
    glm::dvec2 k{0, 0};  ///< wave vector, rad/m
    double amplitude_m = 0;
    double omega = 0;  ///< rad/s
    double phase = 0;  ///< rad
};

/// The waves that `settings` draws: lengths uniform in their logarithm, directions and phases uniform, each wave with
/// the same share of the steepness. On a periodic side the wave vectors are moved to the nearest that fits `grid`.
/// Frequencies are those of Airy waves. Throws InputError where a setting is out of its range.
std::vector<GerstnerWave> gerstner_waves(const GerstnerSettings& settings, const Grid& grid, Boundary boundary,
                                         const Water& water);

/// The surface of such waves, raised so that its mean is zero to the second power of the steepness. The sum of k a must
/// be below 1.
class GerstnerSea {
  public:
    explicit GerstnerSea(std::vector<GerstnerWave> waves);

    /// Elevation, slope and rate at a fixed place. The particle there is found to 1e-13 of the sum of amplitudes.
    SurfacePoint at(glm::dvec2 at_m, double time_s) const;

    /// Adds elevation (m) and slopes at the centres of row j of `grid`, in float: errors are about 1e-6 of the
    /// amplitude.
    struct Row {
        float* elevation;
        float* slope_x;
        float* slope_y;
    };
    void add_row(const Grid& grid, int j, double time_s, const Row& row) const;

  private:
    f64::Gerstner sums_at(glm::dvec2 particle, double time_s) const;
    glm::dvec2 particle_at(glm::dvec2 at_m, double time_s) const;
    void add_cells(const Grid& grid, int i0, int count, int j, double time_s, const Row& row) const;

    std::vector<GerstnerWave> waves_;
    double amplitude_sum_ = 0;
    double raised_ = 0;
};

}  // namespace waterlight
