#include "gpu/buffer.hpp"

#include <fmt/format.h>

#include <cassert>

#include "gpu/detail/vulkan.hpp"

namespace waterlight::gpu {

namespace {

using Usage = vk::BufferUsageFlagBits;
using Property = vk::MemoryPropertyFlagBits;

constexpr vk::MemoryPropertyFlags seen_by_host = Property::eHostVisible | Property::eHostCoherent;

Buffer::Impl::Block allocate(const Context::Impl& context, std::size_t bytes, vk::BufferUsageFlags usage,
                             std::initializer_list<vk::MemoryPropertyFlags> wishes) {
    Buffer::Impl::Block block;
    block.handle = {context.device, vk::BufferCreateInfo({}, bytes, usage)};
    const vk::MemoryRequirements needs = block.handle.getMemoryRequirements();
    const std::uint32_t type = context.memory_type(needs.memoryTypeBits, wishes);
    block.memory = {context.device, vk::MemoryAllocateInfo(needs.size, type)};
    block.handle.bindMemory(*block.memory, 0);
    return block;
}

void require_size(const Context& context, std::size_t bytes) {
    const std::uint64_t limit = context.device().largest_storage_buffer_b;
    if (bytes > limit)
        throw Error(fmt::format("a storage buffer of {} bytes is more than the {} that {} allows", bytes, limit,
                                context.device().name));
}

}  // namespace

Buffer::Buffer(std::shared_ptr<Context> context, std::size_t bytes, BufferUse use) : impl_(std::make_unique<Impl>()) {
    assert(bytes > 0);
    require_size(*context, bytes);
    impl_->bytes = bytes;
    impl_->use = use;
    const Context::Impl& c = context->impl();
    attempt(fmt::format("allocate {} bytes on {}", bytes, context->device().name), [&] {
        const vk::BufferUsageFlags usage = Usage::eStorageBuffer | Usage::eUniformBuffer | Usage::eUniformTexelBuffer |
                                           Usage::eTransferSrc | Usage::eTransferDst;
        const bool host = use != BufferUse::device;
        if (host && c.unified) {
            impl_->main = allocate(c, bytes, usage, {seen_by_host | Property::eHostCached, seen_by_host});
            impl_->mapped = impl_->main.memory.mapMemory(0, VK_WHOLE_SIZE);
            return;
        }
        impl_->main = allocate(c, bytes, usage, {Property::eDeviceLocal, {}});
        if (!host) return;
        // Reading memory that the host does not cache is slow; writing it is not.
        const vk::MemoryPropertyFlags best =
            use == BufferUse::from_host ? seen_by_host : seen_by_host | Property::eHostCached;
        impl_->staging = allocate(c, bytes, Usage::eTransferSrc | Usage::eTransferDst, {best, seen_by_host});
        impl_->mapped = impl_->staging.memory.mapMemory(0, VK_WHOLE_SIZE);
    });
    impl_->context = std::move(context);
}

Buffer::~Buffer() = default;
Buffer::Buffer(Buffer&&) noexcept = default;
Buffer& Buffer::operator=(Buffer&&) noexcept = default;

std::size_t Buffer::bytes() const { return impl_->bytes; }

void* Buffer::mapped() const {
    assert(impl_->mapped != nullptr);
    return impl_->mapped;
}

}  // namespace waterlight::gpu
