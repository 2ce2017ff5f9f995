#include "render/passes/beams.hpp"

#include "shaders/beams.hpp"
#include "shaders/whole.hpp"

namespace waterlight {

namespace {

gpu::RasterSettings settings() {
    gpu::RasterSettings s = surface_settings("beams", shaders::whole, shaders::beams);
    s.texels.push_back(gpu::Texels::r32f);
    s.blend = gpu::Blend::add;
    s.depth = gpu::Depth::none;
    return s;
}

}  // namespace

BeamsPass::BeamsPass(std::shared_ptr<gpu::Context> context) : pass_(std::move(context), settings()) {}

void BeamsPass::record(const Frame& frame) {
    const Field<float>& image = frame.scene.beams->radiance;
    PassParameters p = frame.view;
    p.columns = image.nx();
    p.rows = image.ny();
    p.u1 = static_cast<float>(frame.camera.size.x);
    p.v1 = static_cast<float>(frame.camera.size.y);
    frame.commands.draw(pass_.bound(frame, frame.variant, &*frame.buffers.beams), frame.radiance, {1, 3}, p);
}

}  // namespace waterlight
