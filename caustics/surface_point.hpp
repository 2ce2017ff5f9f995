// A sampled surface at any place.
#pragma once

#include "sim/sines.hpp"
#include "sim/surface.hpp"

namespace waterlight {

/// Elevation and slope, bilinear between the cells; beyond periodic sides they repeat, beyond walls they are mirrored,
/// beyond absorbing sides the water is still.
SurfacePoint surface_point(const Surface& surface, glm::dvec2 at_m);

/// A bound on the slope between the cells' elevations, those on both sides of a periodic side included: of the bilinear
/// surface, and of triangles through the cells' centres.
double steepest_slope(const Surface& surface);

}  // namespace waterlight
