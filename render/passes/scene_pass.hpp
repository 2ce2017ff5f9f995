// A pass of a picture, compiled for each variant of a scene that comes.
#pragma once

#include <map>
#include <vector>

#include "gpu/raster.hpp"
#include "render/frame.hpp"

namespace waterlight {

class ScenePass {
  public:
    /// `base` holds all but constants and samples.
    ScenePass(std::shared_ptr<gpu::Context> context, gpu::RasterSettings base);

    /// The raster pass of this variant, bound to the frame's buffers; `more` are numbers at the binding after them.
    gpu::Raster& bound(const Frame& frame, const Variant& variant, const gpu::Buffer* more = nullptr);

  private:
    std::shared_ptr<gpu::Context> context_;
    gpu::RasterSettings base_;
    struct Bound {
        gpu::Raster raster;
        std::uint64_t frame = 0;  // for which it was bound: a list may draw with it more than once
    };
    std::map<std::vector<std::uint32_t>, Bound> rasters_;  // by constants, then samples
};

/// What all passes that draw surfaces share: buffers, push constants, the radiance's format, depths.
gpu::RasterSettings surface_settings(std::string name, std::span<const std::uint32_t> vertex,
                                     std::span<const std::uint32_t> fragment);

}  // namespace waterlight
