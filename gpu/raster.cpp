#include "gpu/raster.hpp"

#include <fmt/format.h>

#include <array>
#include <cassert>

#include "gpu/detail/vulkan.hpp"

namespace waterlight::gpu {

namespace {

using Stage = vk::ShaderStageFlagBits;

vk::PrimitiveTopology topology_of(Topology topology) {
    return topology == Topology::strip ? vk::PrimitiveTopology::eTriangleStrip : vk::PrimitiveTopology::eTriangleList;
}

vk::PipelineColorBlendAttachmentState blend_of(const RasterSettings& settings) {
    using Factor = vk::BlendFactor;
    using Part = vk::ColorComponentFlagBits;
    const vk::ColorComponentFlags all =
        settings.format == Format::r32f ? vk::ColorComponentFlags(Part::eR) : Part::eR | Part::eG | Part::eB | Part::eA;
    if (settings.blend == Blend::replace) return vk::PipelineColorBlendAttachmentState().setColorWriteMask(all);
    const Factor kept = settings.blend == Blend::add ? Factor::eOne : Factor::eOneMinusSrcAlpha;
    return {true, Factor::eOne, kept, vk::BlendOp::eAdd, Factor::eOne, kept, vk::BlendOp::eAdd, all};
}

vk::PipelineDepthStencilStateCreateInfo depth_of(Depth depth) {
    return {{}, depth != Depth::none, depth == Depth::test_and_set, vk::CompareOp::eGreaterOrEqual};
}

vk::raii::Pipeline make_pipeline(const vk::raii::Device& device, const RasterSettings& settings,
                                 const vk::PipelineLayout& layout) {
    std::vector<vk::SpecializationMapEntry> entries;
    constexpr std::uint32_t word = sizeof(std::uint32_t);
    for (std::uint32_t i = 0; i < settings.constants.size(); ++i) entries.emplace_back(i, i * word, word);
    const vk::SpecializationInfo constants(static_cast<std::uint32_t>(entries.size()), entries.data(),
                                           word * settings.constants.size(), settings.constants.data());
    const auto module = [&](std::span<const std::uint32_t> spirv) {
        return vk::raii::ShaderModule(device, vk::ShaderModuleCreateInfo({}, spirv.size_bytes(), spirv.data()));
    };
    const vk::raii::ShaderModule vertex = module(settings.vertex_spirv), fragment = module(settings.fragment_spirv);
    const std::array<vk::PipelineShaderStageCreateInfo, 2> stages{
        vk::PipelineShaderStageCreateInfo({}, Stage::eVertex, *vertex, "main", &constants),
        vk::PipelineShaderStageCreateInfo({}, Stage::eFragment, *fragment, "main", &constants)};
    const vk::PipelineVertexInputStateCreateInfo pulled;
    const vk::PipelineInputAssemblyStateCreateInfo assembly({}, topology_of(settings.topology));
    const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
    const vk::PipelineRasterizationStateCreateInfo filled({}, false, false, vk::PolygonMode::eFill,
                                                          vk::CullModeFlagBits::eNone, vk::FrontFace::eCounterClockwise,
                                                          false, 0, 0, 0, 1);
    const vk::PipelineMultisampleStateCreateInfo multisample({}, sample_bit(settings.samples));
    const vk::PipelineDepthStencilStateCreateInfo depth = depth_of(settings.depth);
    const vk::PipelineColorBlendAttachmentState blended = blend_of(settings);
    const vk::PipelineColorBlendStateCreateInfo blend({}, false, vk::LogicOp::eCopy, blended);
    const std::array<vk::DynamicState, 2> varying{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic({}, varying);
    vk::GraphicsPipelineCreateInfo info({}, stages, &pulled, &assembly, nullptr, &viewport, &filled, &multisample,
                                        &depth, &blend, &dynamic, layout);
    const vk::Format colour = vulkan_format(settings.format);
    vk::PipelineRenderingCreateInfo rendering(0, colour);
    if (settings.depth != Depth::none) rendering.setDepthAttachmentFormat(depth_format);
    info.setPNext(&rendering);
    return {device, nullptr, info};
}

}  // namespace

Raster::Raster(std::shared_ptr<Context> context, const RasterSettings& settings) : impl_(std::make_unique<Impl>()) {
    require_drawing(*context);
    impl_->name = settings.name;
    impl_->depth = settings.depth;
    impl_->context = std::move(context);
    attempt("build the pass " + settings.name, [&] {
        const vk::raii::Device& device = impl_->context->impl().device;
        impl_->binding = Binding(device, {settings.uniforms, settings.buffers, settings.targets, settings.texels},
                                 settings.push_bytes, Stage::eVertex | Stage::eFragment);
        impl_->pipeline = make_pipeline(device, settings, *impl_->binding.layout);
    });
}

Raster::~Raster() = default;
Raster::Raster(Raster&&) noexcept = default;
Raster& Raster::operator=(Raster&&) noexcept = default;

void Raster::bind(std::initializer_list<const Buffer*> buffers, std::initializer_list<const Target*> targets,
                  std::initializer_list<const Buffer*> texels) {
    impl_->binding.bind(*impl_->context, buffers, targets, texels);
    impl_->read.assign(targets);
}

}  // namespace waterlight::gpu
