// Photons in the camera's pixels (Kim, "Caustics Using Screen-Space Photon Mapping", Ray Tracing Gems, 2019).
#pragma once

#include "caustics/camera.hpp"
#include "caustics/objects/water_scene.hpp"
#include "caustics/photons/photons.hpp"

namespace waterlight {

/// Irradiance, W/m2, on the floor and on diffuse objects in each pixel of the camera, row 0 the lowest: the mean over
/// the pixel, what shows no such receiver counting as 0. A place is in the pixel in which a straight line from the
/// camera ends on it, through water and glass alike and not through what is opaque: whoever has found by refraction
/// what an eye sees looks up the place, as in a shadow map. Light that comes to the receiver from its other side is not
/// seen. Periodic sides do not show the domain again. `settings` give light, optics of the floor apart from those of
/// `scene`, and options: the passes are all followed, `blur_pixels` are the camera's. Its `plan` tells what of the
/// floor is to be lit beyond absorbing sides. Throws InputError where a setting is out of its range. The same bytes for
/// any number of threads.
Field<float> screen_photons(const PhotonSettings& settings, const WaterScene& scene, const Camera& camera);

}  // namespace waterlight
