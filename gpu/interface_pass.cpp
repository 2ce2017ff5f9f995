#include "gpu/detail/interface_pass.hpp"

#include <algorithm>
#include <cassert>

#include "shaders/interface_corners.hpp"
#include "shaders/interface_letters.hpp"

namespace waterlight::gpu {

namespace {

using Stage = vk::ShaderStageFlagBits;

struct Frame {
    std::array<float, 2> size;
    std::array<std::int32_t, 2> atlas_size;
};

// Letters lie over what is there by their opacity.
constexpr vk::PipelineColorBlendAttachmentState over(true, vk::BlendFactor::eSrcAlpha,
                                                     vk::BlendFactor::eOneMinusSrcAlpha, vk::BlendOp::eAdd,
                                                     vk::BlendFactor::eOne, vk::BlendFactor::eOneMinusSrcAlpha,
                                                     vk::BlendOp::eAdd,
                                                     vk::ColorComponentFlagBits::eR | vk::ColorComponentFlagBits::eG |
                                                         vk::ColorComponentFlagBits::eB |
                                                         vk::ColorComponentFlagBits::eA);

vk::raii::Pipeline make_pipeline(const vk::raii::Device& device, const vk::PipelineLayout& layout, vk::Format format) {
    const auto module = [&](std::span<const std::uint32_t> spirv) {
        return vk::raii::ShaderModule(device, vk::ShaderModuleCreateInfo({}, spirv.size_bytes(), spirv.data()));
    };
    const vk::raii::ShaderModule corners = module(shaders::interface_corners);
    const vk::raii::ShaderModule letters = module(shaders::interface_letters);
    const std::array<vk::PipelineShaderStageCreateInfo, 2> stages{
        vk::PipelineShaderStageCreateInfo({}, Stage::eVertex, *corners, "main"),
        vk::PipelineShaderStageCreateInfo({}, Stage::eFragment, *letters, "main")};
    const vk::PipelineVertexInputStateCreateInfo pulled;
    const vk::PipelineInputAssemblyStateCreateInfo triangles({}, vk::PrimitiveTopology::eTriangleList);
    const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
    const vk::PipelineRasterizationStateCreateInfo filled({}, false, false, vk::PolygonMode::eFill,
                                                          vk::CullModeFlagBits::eNone, vk::FrontFace::eCounterClockwise,
                                                          false, 0, 0, 0, 1);
    const vk::PipelineMultisampleStateCreateInfo one_sample;
    const vk::PipelineColorBlendStateCreateInfo blend({}, false, vk::LogicOp::eCopy, over);
    const std::array<vk::DynamicState, 2> varying{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic({}, varying);
    vk::GraphicsPipelineCreateInfo info({}, stages, &pulled, &triangles, nullptr, &viewport, &filled, &one_sample,
                                        nullptr, &blend, &dynamic, layout);
    const vk::PipelineRenderingCreateInfo rendering(0, format);
    info.setPNext(&rendering);
    return {device, nullptr, info};
}

// Vulkan wants a scissor within the image.
vk::Rect2D clipped(const InterfaceBatch& batch, vk::Extent2D size) {
    const auto within = [](std::int32_t value, std::uint32_t most) {
        return std::clamp(value, 0, static_cast<std::int32_t>(most));
    };
    const vk::Offset2D from(within(batch.clip_from[0], size.width), within(batch.clip_from[1], size.height));
    const vk::Offset2D to(within(batch.clip_to[0], size.width), within(batch.clip_to[1], size.height));
    return {from, vk::Extent2D(static_cast<std::uint32_t>(std::max(to.x - from.x, 0)),
                               static_cast<std::uint32_t>(std::max(to.y - from.y, 0)))};
}

template <class T>
void fill(const Buffer& buffer, std::span<const T> values) {
    std::copy(values.begin(), values.end(), buffer.host<T>().begin());
}

}  // namespace

InterfacePass::InterfacePass(std::shared_ptr<Context> context, const InterfaceAtlas& atlas)
    : context_(std::move(context)),
      commands_(context_),
      atlas_(context_, atlas.opacity.size(), BufferUse::from_host),
      atlas_size_{static_cast<std::int32_t>(atlas.width), static_cast<std::int32_t>(atlas.height)} {
    assert(atlas.opacity.size() == std::size_t{atlas.width} * atlas.height && atlas.opacity.size() % 4 == 0);
    fill(atlas_, atlas.opacity);
    commands_.upload(atlas_);
    commands_.run();
    attempt("make the pass of the interface", [&] {
        binding_ = Binding(context_->impl().device, {.buffers = 3}, sizeof(Frame), Stage::eVertex | Stage::eFragment);
    });
}

void InterfacePass::reserve(std::optional<Buffer>& buffer, std::size_t bytes) {
    if (!buffer || buffer->bytes() < bytes)
        buffer.emplace(context_, std::max<std::size_t>(2 * bytes, 1 << 16), BufferUse::from_host);
}

void InterfacePass::load(const InterfaceDrawing& drawing) {
    batches_ = drawing.batches;
    if (batches_.empty()) return;
    reserve(corners_, sizeof(InterfaceCorner) * drawing.corners.size());
    reserve(indices_, sizeof(std::uint32_t) * drawing.indices.size());
    fill<InterfaceCorner>(*corners_, drawing.corners);
    fill<std::uint32_t>(*indices_, drawing.indices);
    binding_.bind(*context_, {&*corners_, &*indices_, &atlas_});
    commands_.upload(*corners_);
    commands_.upload(*indices_);
    if (corners_->impl().staged()) commands_.run();
}

void InterfacePass::draw(const vk::raii::CommandBuffer& list, vk::Format format, vk::Extent2D size) {
    if (batches_.empty()) return;
    if (format != format_) pipeline_ = make_pipeline(context_->impl().device, *binding_.layout, format);
    format_ = format;
    const Frame frame{{static_cast<float>(size.width), static_cast<float>(size.height)}, atlas_size_};
    list.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline_);
    binding_.use(list, vk::PipelineBindPoint::eGraphics, std::as_bytes(std::span(&frame, 1)));
    list.setViewport(0, vk::Viewport(0, 0, frame.size[0], frame.size[1], 0, 1));
    for (const InterfaceBatch& batch : batches_) {
        list.setScissor(0, clipped(batch, size));
        list.draw(batch.indices, 1, batch.first_index, 0);
    }
}

}  // namespace waterlight::gpu
