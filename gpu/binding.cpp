// The buffers, pictures and push constants of a pass.
#include <fmt/format.h>

#include <cassert>

#include "gpu/detail/vulkan.hpp"

namespace waterlight::gpu {

namespace {

using Type = vk::DescriptorType;

vk::Format vulkan_format(Texels texels) {
    switch (texels) {
        case Texels::rg32f:
            return vk::Format::eR32G32Sfloat;
        case Texels::rgba32f:
            return vk::Format::eR32G32B32A32Sfloat;
        case Texels::r32f:
            break;
    }
    return vk::Format::eR32Sfloat;
}

std::size_t bytes_of(Texels texels) {
    return sizeof(float) * (texels == Texels::rgba32f ? 4 : (texels == Texels::rg32f ? 2 : 1));
}

vk::raii::BufferView make_view(Context& context, const Buffer& buffer, Texels texels) {
    const std::size_t count = buffer.bytes() / bytes_of(texels), most = context.device().most_texels;
    if (count > most)
        throw Error(
            fmt::format("a buffer of {} texels is more than the {} that {} reads", count, most, context.device().name));
    return {context.impl().device,
            vk::BufferViewCreateInfo({}, *buffer.impl().main.handle, vulkan_format(texels), 0, VK_WHOLE_SIZE)};
}

std::uint32_t all_of(const BoundCounts& counts) {
    return counts.buffers + counts.targets + static_cast<std::uint32_t>(counts.texels.size());
}

Type type_of(const BoundCounts& counts, std::uint32_t binding) {
    if (binding >= counts.buffers + counts.targets) return Type::eUniformTexelBuffer;
    if (binding >= counts.buffers) return Type::eSampledImage;
    return binding < counts.uniforms ? Type::eUniformBuffer : Type::eStorageBuffer;
}

vk::raii::DescriptorSetLayout make_set_layout(const vk::raii::Device& device, const BoundCounts& counts,
                                              vk::ShaderStageFlags stages) {
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (std::uint32_t i = 0; i < all_of(counts); ++i) bindings.emplace_back(i, type_of(counts, i), 1, stages);
    return {device, vk::DescriptorSetLayoutCreateInfo({}, bindings)};
}

vk::raii::PipelineLayout make_layout(const vk::raii::Device& device, const vk::DescriptorSetLayout& set_layout,
                                     std::uint32_t push_bytes, vk::ShaderStageFlags stages) {
    const vk::PushConstantRange range(stages, 0, push_bytes);
    vk::PipelineLayoutCreateInfo info({}, set_layout);
    if (push_bytes > 0) info.setPushConstantRanges(range);
    return {device, info};
}

}  // namespace

Binding::Binding(const vk::raii::Device& device, BoundCounts bound, std::uint32_t bytes_pushed,
                 vk::ShaderStageFlags used_in)
    : counts(std::move(bound)), push_bytes(bytes_pushed), stages(used_in) {
    assert(counts.buffers > 0 && counts.uniforms <= counts.buffers && push_bytes % 4 == 0 && push_bytes <= 128);
    set_layout = make_set_layout(device, counts, stages);
    layout = make_layout(device, *set_layout, push_bytes, stages);
    std::vector<vk::DescriptorPoolSize> sizes;
    for (std::uint32_t i = 0; i < all_of(counts); ++i) sizes.emplace_back(type_of(counts, i), 1);
    pool = {device, vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes)};
    vk::raii::DescriptorSets sets(device, vk::DescriptorSetAllocateInfo(*pool, *set_layout));
    set = std::move(sets.front());
}

void Binding::bind(Context& context, std::initializer_list<const Buffer*> all,
                   std::initializer_list<const Target*> read, std::initializer_list<const Buffer*> texels) {
    assert(all.size() == counts.buffers && read.size() == counts.targets && texels.size() == counts.texels.size());
    std::vector<vk::DescriptorBufferInfo> buffers;
    for (const Buffer* buffer : all) buffers.emplace_back(*buffer->impl().main.handle, 0, VK_WHOLE_SIZE);
    std::vector<vk::DescriptorImageInfo> images;
    for (const Target* target : read)
        images.emplace_back(vk::Sampler(), *target->impl().drawn().view, vk::ImageLayout::eShaderReadOnlyOptimal);
    views.clear();
    std::vector<vk::BufferView> viewed;
    for (const Buffer* buffer : texels) {
        views.push_back(make_view(context, *buffer, counts.texels[viewed.size()]));
        viewed.push_back(*views.back());
    }
    std::vector<vk::WriteDescriptorSet> writes;
    for (std::uint32_t i = 0; i < all_of(counts); ++i) {
        vk::WriteDescriptorSet write(*set, i, 0, 1, type_of(counts, i));
        if (i < counts.buffers)
            write.setPBufferInfo(&buffers[i]);
        else if (i >= counts.buffers + counts.targets)
            write.setPTexelBufferView(&viewed[i - counts.buffers - counts.targets]);
        else
            write.setPImageInfo(&images[i - counts.buffers]);
        writes.push_back(write);
    }
    context.impl().device.updateDescriptorSets(writes, {});
}

void Binding::use(const vk::raii::CommandBuffer& list, vk::PipelineBindPoint point,
                  std::span<const std::byte> parameters) const {
    assert(parameters.size() == push_bytes);
    list.bindDescriptorSets(point, *layout, 0, *set, {});
    if (!parameters.empty())
        list.pushConstants<std::byte>(*layout, stages, 0,
                                      {static_cast<std::uint32_t>(parameters.size()), parameters.data()});
}

}  // namespace waterlight::gpu
