// Pictures of a scene on a Vulkan device.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "caustics/beam_renderer.hpp"
#include "caustics/camera.hpp"
#include "gpu/context.hpp"
#include "gpu/raster.hpp"
#include "render/look.hpp"
#include "render/radiance.hpp"
#include "render/scene.hpp"

namespace waterlight {

/// Draws the passes that a scene needs, in their order: the water's surface, ground, basin, sky, beams, tone curve.
/// Holds its buffers and targets between pictures.
///
/// Light is followed once: from the surface to sky, floor, walls or ground, and on the camera's way through the water.
/// Beyond that the water's own interreflection is that of an infinite slab (render/kernels/ambient.glsl), so that a
/// white furnace stays white. What it leaves out:
/// - the camera is either above or below the surface, told at its place; no picture shows both sides of a waterline;
/// - waves neither hide nor mirror each other in what they reflect, and reflections above the water show the sky alone,
///   not walls or land; what would be reflected below the horizon is taken for the horizon's;
/// - of scattered light only the sun's, scattered once; the sky's is left out;
/// - where ground is not flat, a shore is cut at whole pixels, and beyond absorbing sides ground is as high as at them.
/// Radiance is kept as half floats in units of the exposure, to 0.05 % and at most 6e4 exposures.
class SceneRenderer {
  public:
    /// Throws gpu::Error where the device cannot draw.
    explicit SceneRenderer(std::shared_ptr<gpu::Context> context);
    ~SceneRenderer();

    /// Draws the scene as the camera sees it, camera.size pixels; waits until it is done. Throws InputError where a
    /// setting is out of its range, gpu::Error where the device fails.
    void draw(const Scene& scene, const Look& look, const Camera& camera);

    /// The last picture: 8-bit sRGB after the tone curve, on the device.
    const gpu::Target& picture() const;
    /// The same for the host: red, green, blue, alpha of each pixel, rows from the lowest up.
    std::vector<std::uint8_t> read_picture();
    /// The last picture's linear radiance.
    Radiance read_radiance();
    /// Of the last picture, by pass, in order.
    const std::vector<StageTime>& stage_times() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace waterlight
