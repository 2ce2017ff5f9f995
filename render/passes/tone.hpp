// Tone curve and sRGB: from radiance to the picture. Samples of a pixel are averaged as radiance, before the tone
// curve: a pixel at an edge then has the light that falls on it, as a lens would give it.
#pragma once

#include <map>

#include "gpu/raster.hpp"
#include "render/frame.hpp"

namespace waterlight {

class TonePass {
  public:
    explicit TonePass(std::shared_ptr<gpu::Context> context) : context_(std::move(context)) {}
    void record(const Frame& frame);

  private:
    std::shared_ptr<gpu::Context> context_;
    std::map<std::uint32_t, gpu::Raster> rasters_;  // by samples of a pixel
};

}  // namespace waterlight
