// The buffers and push constants of a pass.
#include <cassert>

#include "gpu/detail/vulkan.hpp"

namespace waterlight::gpu {

namespace {

vk::raii::DescriptorSetLayout make_set_layout(const vk::raii::Device& device, std::uint32_t buffers,
                                              vk::ShaderStageFlags stages) {
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (std::uint32_t i = 0; i < buffers; ++i) bindings.emplace_back(i, vk::DescriptorType::eStorageBuffer, 1, stages);
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
                 vk::ShaderStageFlags used_in)
    : buffers(buffer_count), push_bytes(bytes_pushed), stages(used_in) {
    assert(buffers > 0 && push_bytes % 4 == 0 && push_bytes <= 128);
    set_layout = make_set_layout(device, buffers, stages);
    layout = make_layout(device, *set_layout, push_bytes, stages);
    const vk::DescriptorPoolSize size(vk::DescriptorType::eStorageBuffer, buffers);
    pool = {device, vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, size)};
    vk::raii::DescriptorSets sets(device, vk::DescriptorSetAllocateInfo(*pool, *set_layout));
    set = std::move(sets.front());
}

void Binding::bind(const vk::raii::Device& device, std::initializer_list<const Buffer*> all) const {
    assert(all.size() == buffers);
    std::vector<vk::DescriptorBufferInfo> infos;
    for (const Buffer* buffer : all) infos.emplace_back(*buffer->impl().main.handle, 0, VK_WHOLE_SIZE);
    const vk::WriteDescriptorSet write(*set, 0, 0, vk::DescriptorType::eStorageBuffer, {}, infos);
    // One write fills all bindings: Vulkan lets it run on into the next binding of the same type.
    device.updateDescriptorSets(write, {});
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
