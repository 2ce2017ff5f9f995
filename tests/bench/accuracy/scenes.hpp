// The scenes of the accuracy report: waves of 0.5 m over one period of their pattern, and their truth.
#pragma once

#include <string>

#include "tests/support/surfaces.hpp"

namespace waterlight::accuracy {

inline constexpr double wave_m = .5;
inline constexpr Boundary periodic{Side::periodic, Side::periodic};

struct Scene {
    std::string name;
    test::Formula waves;
    glm::dvec2 period_m;
    Sun sun{90, 0, 1};
    int aspect = 1;    ///< pixels along y for each along x, over one period; 0: all is the same along y
    int finest = 256;  ///< pixels along x of one period of the truth
};

Scene frozen_sine(double amplitude_m);
Scene egg_crate();
Scene crossed_waves();
Scene skew_wave();

/// The least depth at which rays of neighbours meet, m: the smallest root of the landing map's determinant, which is
/// quadratic in the depth, over the places of a period.
double first_focus_m(const Scene& scene);

/// The truth of one period at the scene's finest pixels, and its own estimate of its error there.
TruthMap fine_truth(const Scene& scene, double depth_m);

/// The same in pixels of which a period has p along x.
Field<double> truth_at_pixels(const Scene& scene, const TruthMap& fine, int p);

/// Computes the yardstick, a map of 256 x 256 pixels with the pixel footprint, of the sine at 1 m.
std::function<void()> make_yardstick();

/// A whole number of periods, with p pixels along x in each and at least `side` along each side.
Grid many_periods(const Scene& scene, int p, int side);

}  // namespace waterlight::accuracy
