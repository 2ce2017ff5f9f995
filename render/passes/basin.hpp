// What holds the water: the flat floor for a camera in it, the walls' inner sides and the deck around a pool.
#pragma once

#include "render/passes/scene_pass.hpp"

namespace waterlight {

class BasinPass {
  public:
    explicit BasinPass(std::shared_ptr<gpu::Context> context);
    static bool needed(const Frame& frame);
    void record(const Frame& frame);

  private:
    void draw(const Frame& frame, std::uint32_t kind, int first, std::uint32_t count);
    ScenePass pass_;
};

}  // namespace waterlight
