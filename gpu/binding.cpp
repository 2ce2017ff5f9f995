// The buffers, pictures and push constants of a pass.
#include <cassert>

#include "gpu/detail/vulkan.hpp"

namespace waterlight::gpu {

namespace {

using Type = vk::DescriptorType;

vk::raii::DescriptorSetLayout make_set_layout(const vk::raii::Device& device, std::uint32_t buffers,
                                              std::uint32_t targets, vk::ShaderStageFlags stages) {
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (std::uint32_t i = 0; i < buffers + targets; ++i)
        bindings.emplace_back(i, i < buffers ? Type::eStorageBuffer : Type::eSampledImage, 1, stages);
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

Binding::Binding(const vk::raii::Device& device, std::uint32_t buffer_count, std::uint32_t bytes_pushed,
                 vk::ShaderStageFlags used_in, std::uint32_t target_count)
    : buffers(buffer_count), targets(target_count), push_bytes(bytes_pushed), stages(used_in) {
    assert(buffers > 0 && push_bytes % 4 == 0 && push_bytes <= 128);
    set_layout = make_set_layout(device, buffers, targets, stages);
    layout = make_layout(device, *set_layout, push_bytes, stages);
    std::vector<vk::DescriptorPoolSize> sizes{{Type::eStorageBuffer, buffers}};
    if (targets > 0) sizes.emplace_back(Type::eSampledImage, targets);
    pool = {device, vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes)};
    vk::raii::DescriptorSets sets(device, vk::DescriptorSetAllocateInfo(*pool, *set_layout));
    set = std::move(sets.front());
}

void Binding::bind(const vk::raii::Device& device, std::initializer_list<const Buffer*> all,
                   std::initializer_list<const Target*> read) const {
    assert(all.size() == buffers && read.size() == targets);
    std::vector<vk::DescriptorBufferInfo> infos;
    for (const Buffer* buffer : all) infos.emplace_back(*buffer->impl().main.handle, 0, VK_WHOLE_SIZE);
    std::vector<vk::DescriptorImageInfo> images;
    for (const Target* target : read)
        images.emplace_back(vk::Sampler(), *target->impl().pixels.view, vk::ImageLayout::eShaderReadOnlyOptimal);
    // One write fills all bindings of a type: Vulkan lets it run on into the next binding of the same type.
    std::vector<vk::WriteDescriptorSet> writes{{*set, 0, 0, Type::eStorageBuffer, {}, infos}};
    if (!images.empty()) writes.emplace_back(*set, buffers, 0, Type::eSampledImage, images);
    device.updateDescriptorSets(writes, {});
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
