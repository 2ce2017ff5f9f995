#include "gpu/presenter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "gpu/detail/interface_pass.hpp"
#include "gpu/detail/vulkan.hpp"

namespace waterlight::gpu {

namespace {

using Stage = vk::PipelineStageFlagBits2;
using Access = vk::AccessFlagBits2;
using Layout = vk::ImageLayout;
using Usage = vk::ImageUsageFlagBits;

constexpr std::uint64_t patience_ns = 500'000'000;  // for an image that the window system keeps

// Pictures are sRGB already: a format that encodes what it is given would do so twice.
vk::SurfaceFormatKHR choose_format(const std::vector<vk::SurfaceFormatKHR>& offered) {
    for (const vk::Format wanted : {vk::Format::eB8G8R8A8Unorm, vk::Format::eR8G8B8A8Unorm})
        for (const vk::SurfaceFormatKHR& format : offered)
            if (format.format == wanted && format.colorSpace == vk::ColorSpaceKHR::eSrgbNonlinear) return format;
    throw Error("the window takes no pictures of 8 bits a colour");
}

vk::Extent2D choose_extent(const vk::SurfaceCapabilitiesKHR& can, vk::Extent2D wanted) {
    if (can.currentExtent.width != UINT32_MAX) return can.currentExtent;
    return {std::clamp(wanted.width, can.minImageExtent.width, can.maxImageExtent.width),
            std::clamp(wanted.height, can.minImageExtent.height, can.maxImageExtent.height)};
}

vk::CompositeAlphaFlagBitsKHR choose_alpha(const vk::SurfaceCapabilitiesKHR& can) {
    using Alpha = vk::CompositeAlphaFlagBitsKHR;
    return can.supportedCompositeAlpha & Alpha::eOpaque ? Alpha::eOpaque : Alpha::eInherit;
}

// One more than the least, so that one can be drawn while others wait to be shown.
std::uint32_t choose_count(const vk::SurfaceCapabilitiesKHR& can) {
    const std::uint32_t count = can.minImageCount + 1;
    return can.maxImageCount > 0 ? std::min(count, can.maxImageCount) : count;
}

void relayout(const vk::raii::CommandBuffer& list, vk::Image image, const vk::ImageMemoryBarrier2& change) {
    vk::ImageMemoryBarrier2 barrier = change;
    barrier.setImage(image).setSubresourceRange({vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1});
    barrier.setSrcQueueFamilyIndex(VK_QUEUE_FAMILY_IGNORED).setDstQueueFamilyIndex(VK_QUEUE_FAMILY_IGNORED);
    list.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, barrier));
}

vk::ImageMemoryBarrier2 change(vk::PipelineStageFlags2 after, vk::AccessFlags2 wrote, vk::PipelineStageFlags2 before,
                               vk::AccessFlags2 accesses) {
    return vk::ImageMemoryBarrier2(after, wrote, before, accesses);
}

vk::ImageMemoryBarrier2 between(vk::ImageMemoryBarrier2 barrier, Layout from, Layout to) {
    return barrier.setOldLayout(from).setNewLayout(to);
}

}  // namespace

struct Presenter::Impl {
    struct ChainImage {
        vk::Image handle;
        vk::raii::ImageView view{nullptr};
        vk::raii::Semaphore drawn{nullptr};  // the window system waits for it before it shows the image
    };
    std::shared_ptr<Context> context;
    MakeSurface make_surface;
    InterfacePass interface;
    vk::raii::SurfaceKHR surface{nullptr};
    vk::SurfaceFormatKHR format;
    vk::Extent2D asked, size;  // of the window when the chain was made, and of its images
    bool stale = true;         // the chain no longer fits the window
    vk::raii::SwapchainKHR chain{nullptr};
    std::vector<ChainImage> images;
    vk::raii::Semaphore acquired{nullptr};
    vk::raii::Fence done{nullptr};
    vk::raii::CommandBuffer list{nullptr};

    Impl(std::shared_ptr<Context> owner, MakeSurface maker, const InterfaceAtlas& atlas);
    ~Impl() { forget_chain(); }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    void open_surface();
    void lose_surface();
    void forget_chain() noexcept;
    bool make_chain(vk::Extent2D wanted);
    void make_images();
    bool show(const Target& picture, vk::Extent2D wanted);
    void record(const Target& picture, const ChainImage& image);
    void copy_picture(const Target& picture, const ChainImage& image) const;
    void draw_interface(const ChainImage& image);
    void submit(const ChainImage& image);
    void hand_over(std::uint32_t index);
};

Presenter::Impl::Impl(std::shared_ptr<Context> owner, MakeSurface maker, const InterfaceAtlas& atlas)
    : context(std::move(owner)), make_surface(std::move(maker)), interface(context, atlas) {
    const Context::Impl& c = context->impl();
    acquired = {c.device, vk::SemaphoreCreateInfo()};
    done = {c.device, vk::FenceCreateInfo()};
    vk::raii::CommandBuffers lists(c.device, {*c.pool, vk::CommandBufferLevel::ePrimary, 1});
    list = std::move(lists.front());
    open_surface();
}

void Presenter::Impl::open_surface() {
    const Context::Impl& c = context->impl();
    surface = {c.instance.handle, make_surface(static_cast<VkInstance>(*c.instance.handle))};
    if (!c.physical.getSurfaceSupportKHR(c.queue_family, *surface))
        throw Error("the Vulkan device " + context->device().name + " cannot show pictures in this window");
    format = choose_format(c.physical.getSurfaceFormatsKHR(*surface));
}

void Presenter::Impl::lose_surface() {
    forget_chain();
    surface = nullptr;
    open_surface();
}

// Images are still being shown until the queue is idle; a device that is lost waits for nothing.
void Presenter::Impl::forget_chain() noexcept {
    try {
        context->impl().queue.waitIdle();
    } catch (const vk::Error&) {
    }
    images.clear();
    chain = nullptr;
    stale = true;
}

bool Presenter::Impl::make_chain(vk::Extent2D wanted) {
    const Context::Impl& c = context->impl();
    stale = true;
    c.queue.waitIdle();
    const vk::SurfaceCapabilitiesKHR can = c.physical.getSurfaceCapabilitiesKHR(*surface);
    asked = wanted;
    size = choose_extent(can, wanted);
    if (size.width == 0 || size.height == 0) return false;
    if (!(can.supportedUsageFlags & Usage::eTransferDst)) throw Error("the window takes no copies of pictures");
    images.clear();
    const vk::raii::SwapchainKHR old = std::move(chain);
    const vk::SwapchainCreateInfoKHR info({}, *surface, choose_count(can), format.format, format.colorSpace, size, 1,
                                          Usage::eColorAttachment | Usage::eTransferDst, vk::SharingMode::eExclusive,
                                          {}, can.currentTransform, choose_alpha(can), vk::PresentModeKHR::eFifo, true,
                                          *old);
    chain = {c.device, info};
    make_images();
    stale = false;
    return true;
}

void Presenter::Impl::make_images() {
    const vk::raii::Device& device = context->impl().device;
    for (const VkImage handle : chain.getImages()) {
        const vk::ImageViewCreateInfo view({}, handle, vk::ImageViewType::e2D, format.format, {},
                                           {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1});
        images.push_back({handle, {device, view}, {device, vk::SemaphoreCreateInfo()}});
    }
}

bool Presenter::Impl::show(const Target& picture, vk::Extent2D wanted) {
    if (wanted.width == 0 || wanted.height == 0) return false;
    if ((stale || wanted != asked) && !make_chain(wanted)) return false;
    const auto [result, index] = chain.acquireNextImage(patience_ns, *acquired);
    if (result == vk::Result::eTimeout || result == vk::Result::eNotReady) return false;
    if (result == vk::Result::eSuboptimalKHR) stale = true;
    record(picture, images[index]);
    submit(images[index]);
    hand_over(index);
    return true;
}

void Presenter::Impl::record(const Target& picture, const ChainImage& image) {
    list.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    copy_picture(picture, image);
    draw_interface(image);
    list.end();
}

// Pictures have their lowest row first, windows their highest.
void Presenter::Impl::copy_picture(const Target& picture, const ChainImage& image) const {
    const Target::Impl& source = picture.impl();
    relayout(list, *source.pixels.handle,
             between(change(Stage::eAllCommands, Access::eMemoryWrite, Stage::eBlit, Access::eTransferRead),
                     Layout::eColorAttachmentOptimal, Layout::eTransferSrcOptimal));
    relayout(list, image.handle,
             between(change(Stage::eBlit, {}, Stage::eBlit, Access::eTransferWrite), Layout::eUndefined,
                     Layout::eTransferDstOptimal));
    const auto corner = [](std::uint32_t x, std::uint32_t y, std::int32_t z) {
        return vk::Offset3D(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), z);
    };
    const vk::ImageSubresourceLayers colour(vk::ImageAspectFlagBits::eColor, 0, 0, 1);
    const vk::ImageBlit upright(colour, {corner(0, source.height, 0), corner(source.width, 0, 1)}, colour,
                                {corner(0, 0, 0), corner(size.width, size.height, 1)});
    const bool same = source.width == size.width && source.height == size.height;
    list.blitImage(*source.pixels.handle, Layout::eTransferSrcOptimal, image.handle, Layout::eTransferDstOptimal,
                   upright, same ? vk::Filter::eNearest : vk::Filter::eLinear);
    relayout(list, *source.pixels.handle,
             between(change(Stage::eBlit, {}, Stage::eAllCommands, Access::eMemoryRead | Access::eMemoryWrite),
                     Layout::eTransferSrcOptimal, Layout::eColorAttachmentOptimal));
}

void Presenter::Impl::draw_interface(const ChainImage& image) {
    relayout(list, image.handle,
             between(change(Stage::eBlit, Access::eTransferWrite, Stage::eColorAttachmentOutput,
                            Access::eColorAttachmentRead | Access::eColorAttachmentWrite),
                     Layout::eTransferDstOptimal, Layout::eColorAttachmentOptimal));
    const vk::RenderingAttachmentInfo colour(*image.view, Layout::eColorAttachmentOptimal, {}, {}, {},
                                             vk::AttachmentLoadOp::eLoad, vk::AttachmentStoreOp::eStore);
    list.beginRendering(vk::RenderingInfo({}, {{0, 0}, size}, 1, 0, colour));
    interface.draw(list, format.format, size);
    list.endRendering();
    relayout(
        list, image.handle,
        between(change(Stage::eColorAttachmentOutput, Access::eColorAttachmentWrite, Stage::eColorAttachmentOutput, {}),
                Layout::eColorAttachmentOptimal, Layout::ePresentSrcKHR));
}

void Presenter::Impl::submit(const ChainImage& image) {
    const Context::Impl& c = context->impl();
    const vk::SemaphoreSubmitInfo wait(*acquired, 0, Stage::eBlit);
    const vk::SemaphoreSubmitInfo signal(*image.drawn, 0, Stage::eAllCommands);
    const vk::CommandBufferSubmitInfo work(*list);
    c.queue.submit2(vk::SubmitInfo2({}, wait, work, signal), *done);
    if (c.device.waitForFences(*done, true, UINT64_MAX) != vk::Result::eSuccess)
        throw Error("the Vulkan device did not finish a picture");
    c.device.resetFences(*done);
}

void Presenter::Impl::hand_over(std::uint32_t index) {
    const vk::PresentInfoKHR info(*images[index].drawn, *chain, index);
    if (context->impl().queue.presentKHR(info) == vk::Result::eSuboptimalKHR) stale = true;
}

Presenter::Presenter(std::shared_ptr<Context> context, MakeSurface make_surface, const InterfaceAtlas& atlas) {
    attempt("show pictures in a window",
            [&] { impl_ = std::make_unique<Impl>(std::move(context), std::move(make_surface), atlas); });
}

Presenter::~Presenter() = default;
Presenter::Presenter(Presenter&&) noexcept = default;
Presenter& Presenter::operator=(Presenter&&) noexcept = default;

bool Presenter::present(const Target& picture, const InterfaceDrawing& drawing, std::array<std::uint32_t, 2> size) {
    return attempt("show a picture in the window", [&] {
        try {
            impl_->interface.load(drawing);
            return impl_->show(picture, {size[0], size[1]});
        } catch (const vk::OutOfDateKHRError&) {
            impl_->stale = true;
        } catch (const vk::SurfaceLostKHRError&) {
            impl_->lose_surface();
        }
        return false;
    });
}

}  // namespace waterlight::gpu
