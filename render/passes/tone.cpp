#include "render/passes/tone.hpp"

#include "shaders/tone.hpp"
#include "shaders/whole.hpp"

namespace waterlight {

TonePass::TonePass(std::shared_ptr<gpu::Context> context)
    : raster_(std::move(context), {.name = "tone",
                                   .vertex_spirv = shaders::whole,
                                   .fragment_spirv = shaders::tone,
                                   .buffers = 1,
                                   .push_bytes = 0,
                                   .targets = 1,
                                   .blend = gpu::Blend::replace,
                                   .format = gpu::Format::rgba8}) {}

void TonePass::record(const Frame& frame) {
    raster_.bind({&*frame.buffers.block}, {&frame.radiance});
    frame.commands.draw(raster_, frame.picture, {1, 3});
}

}  // namespace waterlight
