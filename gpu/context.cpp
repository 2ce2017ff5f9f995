#include "gpu/context.hpp"

#include "gpu/detail/vulkan.hpp"

namespace waterlight::gpu {

namespace {

// Features that Vulkan 1.3 grants to everyone who asks: barriers of the newer form, workgroup sizes that are
// specialisation constants, and drawing without render passes.
vk::raii::Device open_device(const vk::raii::PhysicalDevice& physical, std::uint32_t queue_family, bool presents) {
    const float priority = 1;
    const vk::DeviceQueueCreateInfo queue({}, queue_family, 1, &priority);
    vk::PhysicalDeviceVulkan13Features features;
    features.setSynchronization2(true).setMaintenance4(true).setDynamicRendering(true);
    vk::DeviceCreateInfo info({}, queue);
    constexpr const char* swapchain = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
    if (presents) info.setPEnabledExtensionNames(swapchain);
    info.setPNext(&features);
    return {physical, info};
}

}  // namespace

std::uint32_t Context::Impl::memory_type(std::uint32_t allowed,
                                         std::initializer_list<vk::MemoryPropertyFlags> wishes) const {
    for (const vk::MemoryPropertyFlags wish : wishes)
        for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i)
            if ((allowed >> i & 1) != 0 && (memory.memoryTypes[i].propertyFlags & wish) == wish) return i;
    throw Error("the Vulkan device has no memory of the kind that a buffer needs");
}

Context::Context(const ContextSettings& settings) {
    impl_ = std::make_unique<Impl>(make_instance(settings));
    impl_->selection = survey(impl_->instance, settings);
    const Selection& selection = impl_->selection;
    if (!selection.chosen) throw Error(selection.explanation);
    const bool shared = device().type == DeviceType::cpu || device().type == DeviceType::integrated;
    impl_->unified = shared && !settings.staging;
    attempt("open the Vulkan device " + device().name, [&] {
        vk::raii::PhysicalDevices devices(impl_->instance.handle);
        impl_->physical = std::move(devices.at(*selection.chosen));
        impl_->queue_family = *pass_queue_family(impl_->physical);
        impl_->device = open_device(impl_->physical, impl_->queue_family, settings.window_system.has_value());
        impl_->queue = {impl_->device, impl_->queue_family, 0};
        impl_->pool = {impl_->device, vk::CommandPoolCreateInfo(vk::CommandPoolCreateFlagBits::eResetCommandBuffer,
                                                                impl_->queue_family)};
        impl_->memory = impl_->physical.getMemoryProperties();
        const vk::QueueFamilyProperties family = impl_->physical.getQueueFamilyProperties()[impl_->queue_family];
        if (family.timestampValidBits > 0)
            impl_->timestamp_period_ns = impl_->physical.getProperties().limits.timestampPeriod;
    });
}

Context::~Context() = default;

const DeviceDescription& Context::device() const {
    return impl_->selection.candidates[*impl_->selection.chosen].device;
}

const Selection& Context::selection() const { return impl_->selection; }

std::vector<std::string> Context::validation_messages() const {
    const std::lock_guard lock(impl_->instance.messages->mutex);
    return impl_->instance.messages->texts;
}

}  // namespace waterlight::gpu
