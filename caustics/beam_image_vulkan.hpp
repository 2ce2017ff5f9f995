// A picture of beams on a Vulkan device.
#pragma once

#include <memory>
#include <vector>

#include "caustics/beam_renderer.hpp"
#include "gpu/context.hpp"

namespace waterlight {

/// Draws each cell of two beams as the convex outline of its corners, and adds in every pixel what the kernel text says
/// that the ray gathers. Holds the device's buffers between pictures.
class BeamImageVulkan {
  public:
    /// Throws gpu::Error where the device cannot add up floats in a picture.
    explicit BeamImageVulkan(std::shared_ptr<gpu::Context> context);
    ~BeamImageVulkan();

    /// As draw_beams(). Throws InputError as that does, gpu::Error where the device fails.
    void draw(const BeamImageSettings& settings, const Beams& beams, BeamImage& image);
    const std::vector<StageTime>& stage_times() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace waterlight
