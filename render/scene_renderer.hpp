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
#include "render/scene.hpp"

namespace waterlight {

/// Red, green and blue of each pixel one after the other, rows from the lowest up.
struct Radiance {
    glm::ivec2 size{0, 0};
    std::vector<float> rgb;  ///< W/(m2 sr), before the tone curve
};

/// Draws the passes that a scene needs, in their order. Holds its buffers and targets between pictures.
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
