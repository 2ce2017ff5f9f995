#include "gpu/commands.hpp"

#include <cassert>

#include "gpu/detail/vulkan.hpp"

namespace waterlight::gpu {

namespace {

using Stage = vk::PipelineStageFlagBits2;
using Access = vk::AccessFlagBits2;

constexpr vk::PipelineStageFlags2 device_stages = Stage::eComputeShader | Stage::eTransfer;
constexpr vk::AccessFlags2 device_writes = Access::eShaderStorageWrite | Access::eTransferWrite;
constexpr vk::AccessFlags2 device_accesses = device_writes | Access::eShaderStorageRead | Access::eTransferRead;

std::uint32_t groups(std::uint32_t invocations, std::uint32_t workgroup) {
    return (invocations + workgroup - 1) / workgroup;
}

}  // namespace

struct Commands::Impl {
    std::shared_ptr<Context> context;
    std::uint32_t timed_passes = 0;
    vk::raii::CommandBuffer list{nullptr};
    vk::raii::Fence done{nullptr};
    vk::raii::QueryPool stamps{nullptr};
    bool recording = false;
    std::vector<Timing> recorded;  // names of the timed passes in the list
    std::vector<Timing> timings;

    Impl(std::shared_ptr<Context> owner, std::uint32_t timed);
    const vk::raii::CommandBuffer& begin();
    void barrier(vk::PipelineStageFlags2 to_stage, vk::AccessFlags2 to_access) const;
    void read_stamps();
};

Commands::Impl::Impl(std::shared_ptr<Context> owner, std::uint32_t timed) : context(std::move(owner)) {
    const Context::Impl& c = context->impl();
    vk::raii::CommandBuffers lists(c.device, {*c.pool, vk::CommandBufferLevel::ePrimary, 1});
    list = std::move(lists.front());
    done = {c.device, vk::FenceCreateInfo()};
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

void Commands::Impl::barrier(vk::PipelineStageFlags2 to_stage, vk::AccessFlags2 to_access) const {
    const vk::MemoryBarrier2 all(device_stages, device_writes, to_stage, to_access);
    list.pipelineBarrier2(vk::DependencyInfo({}, all));
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
    impl_->barrier(device_stages, device_accesses);
}

void Commands::download(const Buffer& buffer) {
    const Buffer::Impl& b = buffer.impl();
    assert(b.use == BufferUse::to_host || b.use == BufferUse::both);
    const vk::raii::CommandBuffer& list = impl_->begin();
    if (b.staged()) list.copyBuffer(*b.main.handle, *b.staging.handle, vk::BufferCopy(0, 0, b.bytes));
    impl_->barrier(Stage::eHost, Access::eHostRead);
}

void Commands::clear(const Buffer& buffer) {
    impl_->begin().fillBuffer(*buffer.impl().main.handle, 0, VK_WHOLE_SIZE, 0);
    impl_->barrier(device_stages, device_accesses);
}

void Commands::dispatch_bytes(const Pass& pass, Extent extent, std::span<const std::byte> parameters) {
    const Pass::Impl& p = pass.impl();
    assert(parameters.size() == p.settings.push_bytes);
    const vk::raii::CommandBuffer& list = impl_->begin();
    const bool timed = impl_->recorded.size() < impl_->timed_passes;
    const auto first_stamp = static_cast<std::uint32_t>(2 * impl_->recorded.size());

    if (timed) list.writeTimestamp2(Stage::eComputeShader, *impl_->stamps, first_stamp);
    list.bindPipeline(vk::PipelineBindPoint::eCompute, *p.pipeline);
    list.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *p.layout, 0, *p.set, {});
    if (!parameters.empty())
        list.pushConstants<std::byte>(*p.layout, vk::ShaderStageFlagBits::eCompute, 0,
                                      {static_cast<std::uint32_t>(parameters.size()), parameters.data()});
    const auto& workgroup = p.settings.workgroup;
    list.dispatch(groups(extent[0], workgroup[0]), groups(extent[1], workgroup[1]), groups(extent[2], workgroup[2]));
    if (timed) {
        list.writeTimestamp2(Stage::eComputeShader, *impl_->stamps, first_stamp + 1);
        impl_->recorded.push_back({p.settings.name, 0});
    }
    impl_->barrier(device_stages, device_accesses);
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
