#include "gpu/commands.hpp"

#include <cassert>

#include "gpu/detail/vulkan.hpp"

namespace waterlight::gpu {

namespace {

using Stage = vk::PipelineStageFlagBits2;
using Access = vk::AccessFlagBits2;
using Layout = vk::ImageLayout;

constexpr vk::AccessFlags2 device_writes = Access::eShaderStorageWrite | Access::eTransferWrite;
constexpr vk::AccessFlags2 device_accesses =
    device_writes | Access::eShaderStorageRead | Access::eShaderSampledRead | Access::eTransferRead;
constexpr vk::AccessFlags2 drawing_writes = Access::eColorAttachmentWrite | Access::eDepthStencilAttachmentWrite;
constexpr vk::AccessFlags2 drawing_accesses =
    drawing_writes | Access::eColorAttachmentRead | Access::eDepthStencilAttachmentRead | Access::eShaderSampledRead;
constexpr vk::PipelineStageFlags2 drawing_stages = Stage::eVertexShader | Stage::eFragmentShader |
                                                   Stage::eEarlyFragmentTests | Stage::eLateFragmentTests |
                                                   Stage::eColorAttachmentOutput;
// Of images between entries of a list.
constexpr Layout drawn_into = Layout::eColorAttachmentOptimal;
constexpr Layout depth_layout = Layout::eDepthStencilAttachmentOptimal;

std::uint32_t groups(std::uint32_t invocations, std::uint32_t workgroup) {
    return (invocations + workgroup - 1) / workgroup;
}

}  // namespace

struct Commands::Impl {
    std::shared_ptr<Context> context;
    std::uint32_t timed_passes = 0;
    vk::PipelineStageFlags2 stages;  // all that a list may use
    vk::AccessFlags2 writes, accesses;
    vk::raii::CommandBuffer list{nullptr};
    vk::raii::Fence done{nullptr};
    vk::raii::QueryPool stamps{nullptr};
    bool recording = false;
    std::vector<Timing> recorded;  // names of the timed passes in the list
    std::vector<Timing> timings;

    Impl(std::shared_ptr<Context> owner, std::uint32_t timed);
    const vk::raii::CommandBuffer& begin();
    void barrier() const;
    void barrier_to_host() const;
    void relayout(const Image& image, vk::ImageLayout from, vk::ImageLayout to) const;
    template <class Work>
    void timed(const std::string& name, vk::PipelineStageFlags2 stage, Work work);
    void read_stamps();
};

Commands::Impl::Impl(std::shared_ptr<Context> owner, std::uint32_t timed) : context(std::move(owner)) {
    const Context::Impl& c = context->impl();
    vk::raii::CommandBuffers lists(c.device, {*c.pool, vk::CommandBufferLevel::ePrimary, 1});
    list = std::move(lists.front());
    done = {c.device, vk::FenceCreateInfo()};
    stages = Stage::eComputeShader | Stage::eTransfer;
    writes = device_writes;
    accesses = device_accesses;
    if (context->device().graphics) {
        stages |= drawing_stages;
        writes |= drawing_writes;
        accesses |= drawing_accesses;
    }
    if (timed > 0 && c.timestamp_period_ns > 0) {
        timed_passes = timed;
        stamps = {c.device, vk::QueryPoolCreateInfo({}, vk::QueryType::eTimestamp, 2 * timed)};
    }
}

// The list, open for another entry. What the host wrote before run() is visible to the device by itself.
const vk::raii::CommandBuffer& Commands::Impl::begin() {
    if (!recording) {
        list.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
        if (timed_passes > 0) list.resetQueryPool(*stamps, 0, 2 * timed_passes);
        recording = true;
    }
    return list;
}

// Between any two entries, so that the later sees what the earlier wrote.
void Commands::Impl::barrier() const {
    const vk::MemoryBarrier2 all(stages, writes, stages, accesses);
    list.pipelineBarrier2(vk::DependencyInfo({}, all));
}

void Commands::Impl::barrier_to_host() const {
    const vk::MemoryBarrier2 all(stages, writes, Stage::eHost, Access::eHostRead);
    list.pipelineBarrier2(vk::DependencyInfo({}, all));
}

// A barrier that also brings the image into another layout.
void Commands::Impl::relayout(const Image& image, vk::ImageLayout from, vk::ImageLayout to) const {
    const vk::ImageMemoryBarrier2 change(stages, writes, stages, accesses, from, to, VK_QUEUE_FAMILY_IGNORED,
                                         VK_QUEUE_FAMILY_IGNORED, *image.handle, image.range);
    list.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, change));
}

template <class Work>
void Commands::Impl::timed(const std::string& name, vk::PipelineStageFlags2 stage, Work work) {
    const bool stamped = recorded.size() < timed_passes;
    const auto first_stamp = static_cast<std::uint32_t>(2 * recorded.size());
    if (stamped) list.writeTimestamp2(stage, *stamps, first_stamp);
    work();
    if (!stamped) return;
    list.writeTimestamp2(stage, *stamps, first_stamp + 1);
    recorded.push_back({name, 0});
}

void Commands::Impl::read_stamps() {
    timings = std::move(recorded);
    recorded.clear();
    if (timings.empty()) return;
    const std::size_t count = 2 * timings.size();
    const auto [result, ticks] = stamps.getResults<std::uint64_t>(
        0, static_cast<std::uint32_t>(count), count * sizeof(std::uint64_t), sizeof(std::uint64_t),
        vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
    const double tick_s = context->impl().timestamp_period_ns * 1e-9;
    for (std::size_t i = 0; i < timings.size(); ++i)
        timings[i].seconds = static_cast<double>(ticks[2 * i + 1] - ticks[2 * i]) * tick_s;
}

Commands::Commands(std::shared_ptr<Context> context, std::uint32_t timed_passes) {
    attempt("make a command list", [&] { impl_ = std::make_unique<Impl>(std::move(context), timed_passes); });
}

Commands::~Commands() = default;
Commands::Commands(Commands&&) noexcept = default;
Commands& Commands::operator=(Commands&&) noexcept = default;

void Commands::upload(const Buffer& buffer) {
    const Buffer::Impl& b = buffer.impl();
    assert(b.use == BufferUse::from_host || b.use == BufferUse::both);
    if (!b.staged()) return;
    impl_->begin().copyBuffer(*b.staging.handle, *b.main.handle, vk::BufferCopy(0, 0, b.bytes));
    impl_->barrier();
}

void Commands::download(const Buffer& buffer) {
    const Buffer::Impl& b = buffer.impl();
    assert(b.use == BufferUse::to_host || b.use == BufferUse::both);
    const vk::raii::CommandBuffer& list = impl_->begin();
    if (b.staged()) list.copyBuffer(*b.main.handle, *b.staging.handle, vk::BufferCopy(0, 0, b.bytes));
    impl_->barrier_to_host();
}

void Commands::clear(const Buffer& buffer) {
    impl_->begin().fillBuffer(*buffer.impl().main.handle, 0, VK_WHOLE_SIZE, 0);
    impl_->barrier();
}

void Commands::dispatch_bytes(const Pass& pass, Extent extent, std::span<const std::byte> parameters) {
    const Pass::Impl& p = pass.impl();
    const vk::raii::CommandBuffer& list = impl_->begin();
    impl_->timed(p.settings.name, Stage::eComputeShader, [&] {
        list.bindPipeline(vk::PipelineBindPoint::eCompute, *p.pipeline);
        p.binding.use(list, vk::PipelineBindPoint::eCompute, parameters);
        const auto& workgroup = p.settings.workgroup;
        list.dispatch(groups(extent[0], workgroup[0]), groups(extent[1], workgroup[1]),
                      groups(extent[2], workgroup[2]));
    });
    impl_->barrier();
}

void Commands::clear(const Target& target) {
    const vk::raii::CommandBuffer& list = impl_->begin();
    const Image& colours = target.impl().drawn();
    constexpr Layout filled = Layout::eTransferDstOptimal;
    impl_->relayout(colours, Layout::eUndefined, filled);
    list.clearColorImage(*colours.handle, filled, vk::ClearColorValue(std::array{0.0F, 0.0F, 0.0F, 0.0F}),
                         colours.range);
    impl_->relayout(colours, filled, drawn_into);
    clear_depth(target);
}

void Commands::discard(const Target& target) {
    impl_->begin();
    impl_->relayout(target.impl().drawn(), Layout::eUndefined, drawn_into);
    clear_depth(target);
}

void Commands::clear_depth(const Target& target) {
    const Image& depth = target.impl().depth;
    if (!depth) return;
    constexpr Layout filled = Layout::eTransferDstOptimal;
    const vk::raii::CommandBuffer& list = impl_->begin();
    impl_->relayout(depth, Layout::eUndefined, filled);
    list.clearDepthStencilImage(*depth.handle, filled, vk::ClearDepthStencilValue(0, 0), depth.range);
    impl_->relayout(depth, filled, depth_layout);
}

void Commands::draw_bytes(const Raster& raster, const Target& target, Strips strips,
                          std::span<const std::byte> parameters) {
    const Raster::Impl& r = raster.impl();
    const Target::Impl& t = target.impl();
    assert(r.depth == Depth::none || t.depth);
    const vk::raii::CommandBuffer& list = impl_->begin();
    const vk::Rect2D area({0, 0}, {t.width, t.height});
    const auto attached = [](const Image& image, Layout layout) {
        return vk::RenderingAttachmentInfo(*image.view, layout, {}, {}, {}, vk::AttachmentLoadOp::eLoad,
                                           vk::AttachmentStoreOp::eStore);
    };
    for (const Target* read : r.read) impl_->relayout(read->impl().drawn(), drawn_into, Layout::eShaderReadOnlyOptimal);
    impl_->timed(r.name, Stage::eColorAttachmentOutput, [&] {
        const vk::RenderingAttachmentInfo colour = attached(t.drawn(), drawn_into);
        const vk::RenderingAttachmentInfo depth = attached(t.depth, depth_layout);
        list.beginRendering(vk::RenderingInfo({}, area, 1, 0, colour, r.depth == Depth::none ? nullptr : &depth));
        list.bindPipeline(vk::PipelineBindPoint::eGraphics, *r.pipeline);
        list.setViewport(0, vk::Viewport(0, 0, static_cast<float>(t.width), static_cast<float>(t.height), 0, 1));
        list.setScissor(0, area);
        r.binding.use(list, vk::PipelineBindPoint::eGraphics, parameters);
        list.draw(strips.vertices, strips.count, 0, 0);
        list.endRendering();
    });
    for (const Target* read : r.read) impl_->relayout(read->impl().drawn(), Layout::eShaderReadOnlyOptimal, drawn_into);
    impl_->barrier();
}

void Commands::resolve(const Target& target) {
    const Target::Impl& t = target.impl();
    if (!t.many) return;
    constexpr Layout from = Layout::eTransferSrcOptimal, to = Layout::eTransferDstOptimal;
    const vk::ImageSubresourceLayers colour(vk::ImageAspectFlagBits::eColor, 0, 0, 1);
    const vk::ImageResolve all(colour, {0, 0, 0}, colour, {0, 0, 0}, {t.width, t.height, 1});
    const vk::raii::CommandBuffer& list = impl_->begin();
    impl_->relayout(t.many, drawn_into, from);
    impl_->relayout(t.pixels, Layout::eUndefined, to);
    impl_->timed("resolve", Stage::eTransfer,
                 [&] { list.resolveImage(*t.many.handle, from, *t.pixels.handle, to, all); });
    impl_->relayout(t.many, from, drawn_into);
    impl_->relayout(t.pixels, to, drawn_into);
}

void Commands::copy(const Target& target, const Buffer& buffer) {
    const Target::Impl& t = target.impl();
    assert(buffer.bytes() >= target.bytes());
    const vk::BufferImageCopy all(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {0, 0, 0},
                                  {t.width, t.height, 1});
    const vk::raii::CommandBuffer& list = impl_->begin();
    impl_->relayout(t.pixels, drawn_into, Layout::eTransferSrcOptimal);
    list.copyImageToBuffer(*t.pixels.handle, Layout::eTransferSrcOptimal, *buffer.impl().main.handle, all);
    impl_->relayout(t.pixels, Layout::eTransferSrcOptimal, drawn_into);
    impl_->barrier();
}

void Commands::run() {
    attempt("run the passes", [&] {
        const vk::raii::Device& device = impl_->context->impl().device;
        impl_->begin().end();
        impl_->recording = false;
        const vk::CommandBufferSubmitInfo submitted(*impl_->list);
        impl_->context->impl().queue.submit2(vk::SubmitInfo2({}, {}, submitted, {}), *impl_->done);
        if (device.waitForFences(*impl_->done, true, UINT64_MAX) != vk::Result::eSuccess)
            throw Error("the Vulkan device did not finish its passes");
        device.resetFences(*impl_->done);
        impl_->read_stamps();
        impl_->list.reset();
    });
}

const std::vector<Timing>& Commands::timings() const { return impl_->timings; }

}  // namespace waterlight::gpu
