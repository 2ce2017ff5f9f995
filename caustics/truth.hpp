// The truth that floor maps are measured against: double precision, forward. The surface is cut into triangles; each
// carries the sun's power through it to the floor, where its landed triangle is clipped exactly to the pixels. Power
// over area is irradiance, so folds and crossings add up by themselves. Sub-sampling is doubled until the difference
// between two solutions falls below the tolerance.
#pragma once

#include <functional>

#include "caustics/floor.hpp"
#include "sim/sines.hpp"

namespace waterlight {

/// The surface as the truth sees it: known everywhere in double precision. Beyond a wall nothing is lit; beyond other
/// sides `at` is asked for places outside the domain too.
struct TruthSurface {
    Grid grid;
    Boundary boundary;
    std::function<SurfacePoint(glm::dvec2 at_m)> at;
};

/// Bicubic Hermite interpolation of a sampled surface's elevation and slopes: continuous in slope, fourth order in
/// elevation. Beyond its sides: repeated, mirrored, or still. `surface` must outlive the result.
TruthSurface interpolate(const Surface& surface);

/// Whether x lies beyond an absorbing side of [from, from + extent], where the water is still.
inline bool beyond(Side side, double from, double extent, double x) {
    return side == Side::absorbing && (x < from || x > from + extent);
}

struct TruthSettings {
    FloorSettings floor;       ///< `window` is not used: no light is lost
    int subsamples = 4;        ///< triangle pairs per pixel and axis to begin with, >= 1
    int most_subsamples = 32;  ///< where the doubling ends
    double tolerance = 1e-3;   ///< relative RMSE on pixel averages aimed at, > 0
};

struct TruthMap {
    Field<double> irradiance;   ///< W/m2, pixel averages
    int subsamples = 0;         ///< of the finer of the last two solutions, which is the one given
    double error_estimate = 0;  ///< RMS of their difference over the RMS of the map
    FloorLedger ledger;         ///< of all light followed; nothing is lost to a window
};

/// Throws InputError where a setting is out of its range.
TruthMap truth_map(const TruthSettings& settings, const TruthSurface& surface);

/// Irradiance at one point of the floor: sum over the rays that reach it of E0 T (ci / Nz) exp(-c L) / |det dX/dx|,
/// each found by Newton's method from a mesh of spacing_m. Infinite on a caustic. W/m2.
double truth_at(const FloorSettings& settings, const TruthSurface& surface, glm::dvec2 floor_m, double spacing_m);

/// Relative RMSE of a map against the truth, both averaged over boxes of box x box pixels first (box 1: pixel
/// averages).
double relative_rmse(const Field<float>& map, const Field<double>& truth, int box = 1);

}  // namespace waterlight
