// Uneven ground: dry land, and the bed for a camera in the water.
#pragma once

#include "render/passes/scene_pass.hpp"
#include "render/water_mesh.hpp"

namespace waterlight {

class GroundPass {
  public:
    explicit GroundPass(std::shared_ptr<gpu::Context> context);
    static bool needed(const Frame& frame) { return frame.variant.uneven; }
    /// `planned` lies in the frame's buffer of copies.
    void record(const Frame& frame, const WaterMeshes& planned);

  private:
    ScenePass pass_;
};

}  // namespace waterlight
