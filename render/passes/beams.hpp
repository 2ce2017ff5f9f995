// Light of beams that the water scatters towards a camera in it.
#pragma once

#include "render/passes/scene_pass.hpp"

namespace waterlight {

class BeamsPass {
  public:
    explicit BeamsPass(std::shared_ptr<gpu::Context> context);
    static bool needed(const Frame& frame) { return frame.variant.in_water && frame.scene.beams != nullptr; }
    /// After sky and surfaces: it is added to them.
    void record(const Frame& frame);

  private:
    ScenePass pass_;
};

}  // namespace waterlight
