#include "render/passes/sky.hpp"

#include "shaders/sky.hpp"
#include "shaders/whole.hpp"

namespace waterlight {

namespace {

gpu::RasterSettings settings() {
    gpu::RasterSettings s = surface_settings("sky", shaders::whole, shaders::sky);
    s.depth = gpu::Depth::test;
    return s;
}

}  // namespace

SkyPass::SkyPass(std::shared_ptr<gpu::Context> context) : pass_(std::move(context), settings()) {}

void SkyPass::record(const Frame& frame) {
    frame.commands.draw(pass_.bound(frame, frame.variant), frame.radiance, {1, 3}, frame.view);
}

}  // namespace waterlight
