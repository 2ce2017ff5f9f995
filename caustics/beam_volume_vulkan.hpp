// Fields of light in the water on a Vulkan device.
#pragma once

#include <memory>
#include <vector>

#include "caustics/beam_renderer.hpp"
#include "gpu/context.hpp"

namespace waterlight {

/// Shares every beam's section at every depth among the cells, in whole numbers, so that the fields do not depend on
/// the order in which the device works. Holds the device's buffers between frames.
class BeamVolumeVulkan {
  public:
    explicit BeamVolumeVulkan(std::shared_ptr<gpu::Context> context);
    ~BeamVolumeVulkan();

    /// As fill_volume(). Throws InputError as that does, gpu::Error where the device fails.
    void fill(const Beams& beams, glm::ivec3 cells, BeamVolume& volume);
    const std::vector<StageTime>& stage_times() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace waterlight
