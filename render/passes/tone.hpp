// Tone curve and sRGB: from resolved radiance to the picture.
#pragma once

#include "gpu/raster.hpp"
#include "render/frame.hpp"

namespace waterlight {

class TonePass {
  public:
    explicit TonePass(std::shared_ptr<gpu::Context> context);
    void record(const Frame& frame);

  private:
    gpu::Raster raster_;
};

}  // namespace waterlight
