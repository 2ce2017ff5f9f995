// A sampled surface at any place.
#pragma once

#include "sim/sines.hpp"
#include "sim/surface.hpp"

namespace waterlight {

/// Elevation and slope, bilinear between the cells; beyond periodic sides they repeat, beyond walls they are mirrored,
/// beyond absorbing sides the water is still.
SurfacePoint surface_point(const Surface& surface, glm::dvec2 at_m);

}  // namespace waterlight
