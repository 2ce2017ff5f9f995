// The sun's disc, for any back-end of the floor map: the map of parallel light, convolved with the ellipse in which
// light of the disc lands around that of its centre.
#pragma once

#include <functional>

#include "caustics/ellipse_taps.hpp"
#include "caustics/floor.hpp"

namespace waterlight {

/// Makes the mapper of parallel light for these settings.
using FloorMaker = std::function<std::unique_ptr<FloorMapper>(const FloorSettings&)>;

/// What the disc spreads light by on the floor of a plan, pixels^2. The ellipse is that below water at rest: its
/// semi-axes are the derivative of the landing by the sun's direction; waves change it by their slope times itself.
Spread disc_spread(const FloorSettings& settings, double half_angle_deg);

/// A mapper whose sun is a disc of uniform radiance and of this half-angle, 0.2665 degrees as seen from the earth. The
/// plan is enlarged by the ellipse, convolved, and cropped; periodic sides that the map covers wrap instead. The ledger
/// is that of the enlarged plan, and what falls beside the map itself counts as outside. Throws InputError where the
/// half-angle is not in (0, 10] or a setting is out of its range.
std::unique_ptr<FloorMapper> make_sun_disc(const FloorSettings& settings, double half_angle_deg, FloorMaker make);

}  // namespace waterlight
