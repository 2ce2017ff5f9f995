#include "gpu/pass.hpp"

#include <cassert>

#include "gpu/detail/vulkan.hpp"

namespace waterlight::gpu {

namespace {

vk::raii::DescriptorSetLayout make_set_layout(const vk::raii::Device& device, std::uint32_t buffers) {
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (std::uint32_t i = 0; i < buffers; ++i)
        bindings.emplace_back(i, vk::DescriptorType::eStorageBuffer, 1, vk::ShaderStageFlagBits::eCompute);
    return {device, vk::DescriptorSetLayoutCreateInfo({}, bindings)};
}

vk::raii::PipelineLayout make_layout(const vk::raii::Device& device, const vk::DescriptorSetLayout& set_layout,
                                     std::uint32_t push_bytes) {
    const vk::PushConstantRange range(vk::ShaderStageFlagBits::eCompute, 0, push_bytes);
    vk::PipelineLayoutCreateInfo info({}, set_layout);
    if (push_bytes > 0) info.setPushConstantRanges(range);
    return {device, info};
}

vk::raii::Pipeline make_pipeline(const vk::raii::Device& device, const PassSettings& settings,
                                 const vk::PipelineLayout& layout) {
    constexpr std::uint32_t word = sizeof(std::uint32_t);
    const std::array<vk::SpecializationMapEntry, 3> entries{{{0, 0, word}, {1, word, word}, {2, 2 * word, word}}};
    const vk::SpecializationInfo workgroup(entries.size(), entries.data(), sizeof(settings.workgroup),
                                           settings.workgroup.data());
    const vk::raii::ShaderModule shader(
        device, vk::ShaderModuleCreateInfo({}, settings.spirv.size_bytes(), settings.spirv.data()));
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *shader, "main", &workgroup);
    return {device, nullptr, vk::ComputePipelineCreateInfo({}, stage, layout)};
}

}  // namespace

Pass::Pass(std::shared_ptr<Context> context, const PassSettings& settings) : impl_(std::make_unique<Impl>()) {
    assert(settings.buffers > 0 && settings.push_bytes % 4 == 0 && settings.push_bytes <= 128);
    impl_->settings = settings;
    impl_->context = std::move(context);
    attempt("build the pass " + settings.name, [&] {
        const vk::raii::Device& device = impl_->context->impl().device;
        impl_->set_layout = make_set_layout(device, settings.buffers);
        impl_->layout = make_layout(device, *impl_->set_layout, settings.push_bytes);
        impl_->pipeline = make_pipeline(device, settings, *impl_->layout);
        const vk::DescriptorPoolSize size(vk::DescriptorType::eStorageBuffer, settings.buffers);
        impl_->pool = {device,
                       vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, size)};
        vk::raii::DescriptorSets sets(device, vk::DescriptorSetAllocateInfo(*impl_->pool, *impl_->set_layout));
        impl_->set = std::move(sets.front());
    });
}

Pass::~Pass() = default;
Pass::Pass(Pass&&) noexcept = default;
Pass& Pass::operator=(Pass&&) noexcept = default;

void Pass::bind(std::initializer_list<const Buffer*> buffers) {
    assert(buffers.size() == impl_->settings.buffers);
    std::vector<vk::DescriptorBufferInfo> infos;
    for (const Buffer* buffer : buffers) infos.emplace_back(*buffer->impl().main.handle, 0, VK_WHOLE_SIZE);
    const vk::WriteDescriptorSet write(*impl_->set, 0, 0, vk::DescriptorType::eStorageBuffer, {}, infos);
    // One write fills all bindings: Vulkan lets it run on into the next binding of the same type.
    impl_->context->impl().device.updateDescriptorSets(write, {});
}

}  // namespace waterlight::gpu
