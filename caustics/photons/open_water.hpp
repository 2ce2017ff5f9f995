// Photons through water that nothing stands in, to a flat floor: from the surface straight down, with nothing to
// search.
#pragma once

#include "caustics/photons/photon_pass.hpp"

namespace waterlight {

/// Whether all the sun's light goes from the surface to floor or side, and all that is reflected out, whatever the
/// slope where it comes in: by a bound.
bool is_open_water(const PhotonSettings& settings, const Surface& surface);

/// The same photons as those of a scene's tracer with starts on the surface, where is_open_water(). What it is given
/// must outlive it.
std::unique_ptr<PhotonTracer> make_open_water_tracer(const PhotonSettings& settings, const Surface& surface);

}  // namespace waterlight
