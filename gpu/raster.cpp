#include "gpu/raster.hpp"

#include <fmt/format.h>

#include <array>
#include <cassert>

#include "gpu/detail/vulkan.hpp"

namespace waterlight::gpu {

namespace {

using Stage = vk::ShaderStageFlagBits;

void require_drawing(const Context& context) {
    const std::vector<std::string> reasons = drawing_rejections(context.device());
    if (!reasons.empty())
        throw Error(fmt::format("the Vulkan device {} {}, so it cannot draw; --backend cpu can", context.device().name,
                                fmt::join(reasons, " and ")));
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
        vk::PipelineShaderStageCreateInfo({}, Stage::eVertex, *vertex, "main"),
        vk::PipelineShaderStageCreateInfo({}, Stage::eFragment, *fragment, "main", &constants)};
    const vk::PipelineVertexInputStateCreateInfo pulled;
    const vk::PipelineInputAssemblyStateCreateInfo strips({}, vk::PrimitiveTopology::eTriangleStrip);
    const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
    const vk::PipelineRasterizationStateCreateInfo filled({}, false, false, vk::PolygonMode::eFill,
                                                          vk::CullModeFlagBits::eNone, vk::FrontFace::eCounterClockwise,
                                                          false, 0, 0, 0, 1);
    const vk::PipelineMultisampleStateCreateInfo one_sample;
    const vk::PipelineColorBlendAttachmentState added(true, vk::BlendFactor::eOne, vk::BlendFactor::eOne,
                                                      vk::BlendOp::eAdd, vk::BlendFactor::eOne, vk::BlendFactor::eOne,
                                                      vk::BlendOp::eAdd, vk::ColorComponentFlagBits::eR);
    const vk::PipelineColorBlendStateCreateInfo blend({}, false, vk::LogicOp::eCopy, added);
    const std::array<vk::DynamicState, 2> varying{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic({}, varying);
    vk::GraphicsPipelineCreateInfo info({}, stages, &pulled, &strips, nullptr, &viewport, &filled, &one_sample, nullptr,
                                        &blend, &dynamic, layout);
    const vk::PipelineRenderingCreateInfo rendering(0, target_format);
    info.setPNext(&rendering);
    return {device, nullptr, info};
}

}  // namespace

Target::Target(std::shared_ptr<Context> context, std::uint32_t width, std::uint32_t height)
    : impl_(std::make_unique<Impl>()) {
    assert(width > 0 && height > 0);
    require_drawing(*context);
    const std::uint32_t most = context->device().largest_target;
    if (std::max(width, height) > most)
        throw Error(fmt::format("a picture of {} x {} pixels is more than the {} x {} that {} draws into", width,
                                height, most, most, context->device().name));
    impl_->width = width;
    impl_->height = height;
    attempt(fmt::format("make a picture of {} x {} pixels on {}", width, height, context->device().name), [&] {
        const Context::Impl& c = context->impl();
        using Usage = vk::ImageUsageFlagBits;
        impl_->image = {c.device,
                        vk::ImageCreateInfo({}, vk::ImageType::e2D, target_format, {width, height, 1}, 1, 1,
                                            vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal,
                                            Usage::eColorAttachment | Usage::eTransferSrc | Usage::eTransferDst)};
        const vk::MemoryRequirements needs = impl_->image.getMemoryRequirements();
        const std::uint32_t type = c.memory_type(needs.memoryTypeBits, {vk::MemoryPropertyFlagBits::eDeviceLocal, {}});
        impl_->memory = {c.device, vk::MemoryAllocateInfo(needs.size, type)};
        impl_->image.bindMemory(*impl_->memory, 0);
        impl_->view = {c.device, vk::ImageViewCreateInfo({}, *impl_->image, vk::ImageViewType::e2D, target_format, {},
                                                         Impl::whole)};
    });
    impl_->context = std::move(context);
}

Target::~Target() = default;
Target::Target(Target&&) noexcept = default;
Target& Target::operator=(Target&&) noexcept = default;

std::uint32_t Target::width() const { return impl_->width; }
std::uint32_t Target::height() const { return impl_->height; }

Raster::Raster(std::shared_ptr<Context> context, const RasterSettings& settings) : impl_(std::make_unique<Impl>()) {
    require_drawing(*context);
    impl_->name = settings.name;
    impl_->context = std::move(context);
    attempt("build the pass " + settings.name, [&] {
        const vk::raii::Device& device = impl_->context->impl().device;
        impl_->binding = Binding(device, settings.buffers, settings.push_bytes, Stage::eVertex | Stage::eFragment);
        impl_->pipeline = make_pipeline(device, settings, *impl_->binding.layout);
    });
}

Raster::~Raster() = default;
Raster::Raster(Raster&&) noexcept = default;
Raster& Raster::operator=(Raster&&) noexcept = default;

void Raster::bind(std::initializer_list<const Buffer*> buffers) {
    impl_->binding.bind(impl_->context->impl().device, buffers);
}

}  // namespace waterlight::gpu
