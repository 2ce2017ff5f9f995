// The sky, the sun's disc, and the haze of water without end: what is seen where nothing else is.
#pragma once

#include "render/passes/scene_pass.hpp"

namespace waterlight {

class SkyPass {
  public:
    explicit SkyPass(std::shared_ptr<gpu::Context> context);
    /// After all surfaces.
    void record(const Frame& frame);

  private:
    ScenePass pass_;
};

}  // namespace waterlight
