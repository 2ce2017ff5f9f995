// The floor map forward: quads of the refracted surface, landed and shared exactly among the pixels.
#pragma once

#include "caustics/floor.hpp"

namespace waterlight {

/// The mesh has samples_per_pixel squared quads in each pixel; window and footprint are not used and no light is lost.
/// Converges with the pixels as the parallelograms of the two-pass method do; unlike them it has no gaps or overlaps at
/// folds. Throws InputError where a setting is out of its range.
std::unique_ptr<FloorMapper> make_floor_quads(const FloorSettings& settings);

}  // namespace waterlight
