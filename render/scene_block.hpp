// The scene in the words of render/shaders/scene_parameters.glsl.
#pragma once

#include "caustics/camera.hpp"
#include "render/light_maps.hpp"
#include "render/look.hpp"
#include "render/scene.hpp"
#include "render/surface_levels.hpp"

namespace waterlight {

#include "render/shaders/scene_parameters.glsl"

/// The camera's part of every pass's push constants; the rest zero.
PassParameters view_parameters(const Camera& camera);

/// Throws InputError where a setting is out of its range or parts of the scene do not fit each other.
void validate(const Scene& scene, const Look& look, const Camera& camera);

/// `volume_offset` is where the volume begins in the buffer of the medium; `camera_depth_m` is that of a camera in the
/// water, else 0.
SceneParameters scene_parameters(const Scene& scene, const Look& look, const SurfaceLevels& surface,
                                 const LightMaps& maps, int volume_offset, double camera_depth_m);

}  // namespace waterlight
