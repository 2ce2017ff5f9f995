#include "render/passes/tone.hpp"

#include "shaders/tone.hpp"
#include "shaders/tone_single.hpp"
#include "shaders/whole.hpp"

namespace waterlight {

namespace {

gpu::RasterSettings settings(std::uint32_t samples) {
    return {.name = "tone",
            .vertex_spirv = shaders::whole,
            .fragment_spirv = samples > 1 ? shaders::tone : shaders::tone_single,
            .buffers = 1,
            .push_bytes = 0,
            .constants = {samples},
            .uniforms = 1,
            .targets = 1,
            .blend = gpu::Blend::replace,
            .format = gpu::Format::rgba8};
}

}  // namespace

void TonePass::record(const Frame& frame) {
    const std::uint32_t samples = frame.radiance.samples();
    auto found = rasters_.find(samples);
    if (found == rasters_.end()) found = rasters_.emplace(samples, gpu::Raster(context_, settings(samples))).first;
    found->second.bind({&*frame.buffers.block}, {&frame.radiance});
    frame.commands.draw(found->second, frame.picture, {1, 3});
}

}  // namespace waterlight
