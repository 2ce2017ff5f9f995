// The water's surface, from above or below.
#pragma once

#include "render/passes/scene_pass.hpp"
#include "render/water_mesh.hpp"

namespace waterlight {

class WaterPass {
  public:
    explicit WaterPass(std::shared_ptr<gpu::Context> context);
    /// `planned` lies in the frame's buffer of copies.
    void record(const Frame& frame, const WaterMeshes& planned);

  private:
    ScenePass pass_;
};

}  // namespace waterlight
