// The surface of a run as the truth sees it.
#pragma once

#include "caustics/truth.hpp"
#include "sim/prescribed.hpp"

namespace waterlight {

/// The formula at the surface's time where there is one, else the smooth surface through the cells. Both outlive the
/// result.
TruthSurface exact_surface(const Surface& surface, const SurfaceFormula* formula);

}  // namespace waterlight
