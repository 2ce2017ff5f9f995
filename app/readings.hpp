// What is read off each frame: gauges, and statistics of the floor map.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <string_view>

#include "caustics/floor.hpp"
#include "caustics/light_ledger.hpp"
#include "sim/surface.hpp"

namespace waterlight {

/// Of what was not read.
inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// Elevation (m) at a place in the domain, of the smooth surface through the cells (interpolate()): linear
/// interpolation would cut crests by a twelfth at eight cells a wave. Beside dry ground, that of the cell itself.
double elevation_at(const Surface& surface, glm::dvec2 at_m);

/// When in a run.
struct Instant {
    double time_s = 0;
    std::int64_t step = 0;
};

/// Throws WorldError naming field, cell, time and step where a value is not a finite number.
void require_finite(std::string_view name, const Field<float>& field, const Instant& when);
/// All fields of the surface.
void require_finite(const Surface& surface, std::int64_t step);
/// The ledger of `who` follows the light; the same.
void require_finite(std::string_view who, const LightLedger& ledger, const Instant& when);

/// Irradiance (W/m2) of the pixel that holds a place on the floor; NaN beyond the map.
double pixel_at(const FloorPlan& plan, const Field<float>& irradiance, glm::dvec2 at_m);

struct FloorStatistics {
    double mean = 0;
    double min = 0;
    double max = 0;
    double cv = 0;  ///< standard deviation / mean; 0 where the mean is 0
};

FloorStatistics statistics_of(const Field<float>& irradiance);

}  // namespace waterlight
