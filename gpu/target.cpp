// What raster passes draw into.
#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "gpu/detail/vulkan.hpp"

namespace waterlight::gpu {

namespace {

using Usage = vk::ImageUsageFlagBits;
using Aspect = vk::ImageAspectFlagBits;

constexpr vk::ImageUsageFlags copied = Usage::eTransferSrc | Usage::eTransferDst;

vk::ImageCreateInfo described(vk::Format format, vk::Extent2D size, std::uint32_t samples, vk::ImageUsageFlags usage) {
    return {{},
            vk::ImageType::e2D,
            format,
            {size.width, size.height, 1},
            1,
            1,
            sample_bit(samples),
            vk::ImageTiling::eOptimal,
            usage};
}

Image make_image(const Context::Impl& c, const vk::ImageCreateInfo& info, vk::ImageAspectFlags aspect) {
    Image image;
    image.range = vk::ImageSubresourceRange(aspect, 0, 1, 0, 1);
    image.handle = {c.device, info};
    const vk::MemoryRequirements needs = image.handle.getMemoryRequirements();
    const std::uint32_t type = c.memory_type(needs.memoryTypeBits, {vk::MemoryPropertyFlagBits::eDeviceLocal, {}});
    image.memory = {c.device, vk::MemoryAllocateInfo(needs.size, type)};
    image.handle.bindMemory(*image.memory, 0);
    image.view = {c.device,
                  vk::ImageViewCreateInfo({}, *image.handle, vk::ImageViewType::e2D, info.format, {}, image.range)};
    return image;
}

/// The most samples, at most so many, that the device takes for colours and depths.
std::uint32_t most_samples(const vk::raii::PhysicalDevice& device, const TargetSettings& settings) {
    const auto counts = [&](vk::Format format, vk::ImageUsageFlags usage) {
        return device.getImageFormatProperties(format, vk::ImageType::e2D, vk::ImageTiling::eOptimal, usage)
            .sampleCounts;
    };
    vk::SampleCountFlags offered =
        counts(vulkan_format(settings.format), Usage::eColorAttachment | Usage::eSampled | copied);
    if (settings.depth) offered &= counts(depth_format, Usage::eDepthStencilAttachment | Usage::eTransferDst);
    std::uint32_t samples = settings.samples;
    while (samples > 1 && !(offered & sample_bit(samples))) samples /= 2;
    return samples;
}

void check_size(const Context& context, vk::Extent2D size) {
    const std::uint32_t most = context.device().largest_target;
    if (std::max(size.width, size.height) > most)
        throw Error(fmt::format("a picture of {} x {} pixels is more than the {} x {} that {} draws into", size.width,
                                size.height, most, most, context.device().name));
}

std::size_t pixel_bytes(Format format) {
    switch (format) {
        case Format::rgba16f:
            return 8;
        case Format::rgba32f:
            return 16;
        case Format::r32f:
        case Format::rgba8:
            break;
    }
    return 4;
}

}  // namespace

void require_drawing(const Context& context) {
    const std::vector<std::string> reasons = drawing_rejections(context.device());
    if (!reasons.empty())
        throw Error(fmt::format("the Vulkan device {} {}, so it cannot draw; --backend cpu can", context.device().name,
                                fmt::join(reasons, " and ")));
}

vk::Format vulkan_format(Format format) {
    switch (format) {
        case Format::rgba16f:
            return vk::Format::eR16G16B16A16Sfloat;
        case Format::rgba32f:
            return vk::Format::eR32G32B32A32Sfloat;
        case Format::rgba8:
            return vk::Format::eR8G8B8A8Unorm;
        case Format::r32f:
            break;
    }
    return target_format;
}

Target::Target(std::shared_ptr<Context> context, std::uint32_t width, std::uint32_t height,
               const TargetSettings& settings)
    : impl_(std::make_unique<Impl>()) {
    assert(width > 0 && height > 0);
    const vk::Extent2D size(width, height);
    require_drawing(*context);
    check_size(*context, size);
    impl_->width = width;
    impl_->height = height;
    impl_->format = settings.format;
    attempt(fmt::format("make a picture of {} x {} pixels on {}", width, height, context->device().name), [&] {
        const Context::Impl& c = context->impl();
        const vk::Format format = vulkan_format(settings.format);
        impl_->samples = most_samples(c.physical, settings);
        impl_->pixels = make_image(c, described(format, size, 1, Usage::eColorAttachment | Usage::eSampled | copied),
                                   Aspect::eColor);
        if (impl_->samples > 1)
            impl_->many = make_image(
                c, described(format, size, impl_->samples, Usage::eColorAttachment | Usage::eSampled | copied),
                Aspect::eColor);
        if (settings.depth)
            impl_->depth = make_image(
                c, described(depth_format, size, impl_->samples, Usage::eDepthStencilAttachment | Usage::eTransferDst),
                Aspect::eDepth);
    });
    impl_->context = std::move(context);
}

Target::~Target() = default;
Target::Target(Target&&) noexcept = default;
Target& Target::operator=(Target&&) noexcept = default;

std::uint32_t Target::width() const { return impl_->width; }
std::uint32_t Target::height() const { return impl_->height; }
Format Target::format() const { return impl_->format; }
std::uint32_t Target::samples() const { return impl_->samples; }
std::size_t Target::bytes() const { return pixel_bytes(impl_->format) * impl_->width * impl_->height; }

}  // namespace waterlight::gpu
