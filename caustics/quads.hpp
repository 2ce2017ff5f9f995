// The floor map forward: quads of the refracted surface, landed and shared exactly among the pixels.
#pragma once

#include "caustics/floor.hpp"

namespace waterlight {

/// The mesh has samples_per_pixel squared quads in each pixel, corners at its pixels' when the water is at rest; window
/// and footprint are not used, map.window is {1, 1} and no light is lost. A quad's power is what its vector area takes
/// of the sun: without refraction the map is even. Walls cut quads exactly. The ledger counts as the two-pass map's
/// does. On the scenes of tests/laws/quads_accuracy.cpp the error falls with the pixel by an order of 1.1 to 1.6;
/// before the focus it is once to twice that of parallelograms, beyond folds several times it, for a mesh that is
/// straight between its corners misses the fold by a part of a pixel's curvature. More samples a pixel mend that.
/// Objects stop light. The bytes do not depend on the number of threads. Throws InputError where a setting is out of
/// its range.
std::unique_ptr<FloorMapper> make_floor_quads(const FloorSettings& settings);

}  // namespace waterlight
