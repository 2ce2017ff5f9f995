#include "gpu/pass.hpp"

#include "gpu/detail/vulkan.hpp"

namespace waterlight::gpu {

namespace {

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
    impl_->settings = settings;
    impl_->context = std::move(context);
    attempt("build the pass " + settings.name, [&] {
        const vk::raii::Device& device = impl_->context->impl().device;
        impl_->binding = Binding(device, {.buffers = settings.buffers, .texels = settings.texels}, settings.push_bytes,
                                 vk::ShaderStageFlagBits::eCompute);
        impl_->pipeline = make_pipeline(device, settings, *impl_->binding.layout);
    });
}

Pass::~Pass() = default;
Pass::Pass(Pass&&) noexcept = default;
Pass& Pass::operator=(Pass&&) noexcept = default;

void Pass::bind(std::initializer_list<const Buffer*> buffers, std::initializer_list<const Buffer*> texels) {
    impl_->binding.bind(*impl_->context, buffers, {}, texels);
}

}  // namespace waterlight::gpu
