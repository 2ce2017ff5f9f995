#include "render/passes/scene_pass.hpp"

#include <utility>

namespace waterlight {

ScenePass::ScenePass(std::shared_ptr<gpu::Context> context, gpu::RasterSettings base)
    : context_(std::move(context)), base_(std::move(base)) {}

gpu::Raster& ScenePass::bound(const Frame& frame, const Variant& variant, const gpu::Buffer* more) {
    std::vector<std::uint32_t> key = variant.constants();
    gpu::RasterSettings settings = base_;
    settings.constants = key;
    settings.samples = frame.radiance.samples();
    key.push_back(settings.samples);
    auto found = rasters_.find(key);
    if (found == rasters_.end()) found = rasters_.emplace(key, Bound{gpu::Raster(context_, settings)}).first;
    const SceneBuffers& b = frame.buffers;
    gpu::Raster& raster = found->second.raster;
    if (std::exchange(found->second.frame, frame.number) == frame.number) return raster;
    if (more == nullptr)
        raster.bind({&*b.block, &*b.copies, &*b.palette}, {}, {&*b.surface, &*b.light, &*b.medium, &*b.ground});
    else
        raster.bind({&*b.block, &*b.copies, &*b.palette}, {}, {&*b.surface, &*b.light, &*b.medium, &*b.ground, more});
    return raster;
}

gpu::RasterSettings surface_settings(std::string name, std::span<const std::uint32_t> vertex,
                                     std::span<const std::uint32_t> fragment) {
    using enum gpu::Texels;
    return {.name = std::move(name),
            .vertex_spirv = vertex,
            .fragment_spirv = fragment,
            .buffers = 3,
            .push_bytes = sizeof(PassParameters),
            .uniforms = 1,
            .topology = gpu::Topology::strip,
            .blend = gpu::Blend::replace,
            .depth = gpu::Depth::test_and_set,
            .format = gpu::Format::rgba16f,
            .texels = {rgba32f, r32f, r32f, r32f}};
}

}  // namespace waterlight
