// Opening the Vulkan loader, and what it knows of devices.

#include <algorithm>
#include <cstring>

#include "gpu/detail/vulkan.hpp"

namespace waterlight::gpu {

namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";
constexpr const char* no_loader =
    "there is no Vulkan loader: libvulkan.so.1 cannot be opened (Debian's package is libvulkan1)";
constexpr const char* no_driver =
    "the Vulkan loader finds no driver (Debian's mesa-vulkan-drivers holds one that needs no GPU)";

constexpr vk::ApplicationInfo application("waterlight", 1, "waterlight", 1, VK_API_VERSION_1_3);

VKAPI_ATTR vk::Bool32 VKAPI_CALL collect(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* messages) {
    Messages& kept = *static_cast<Messages*>(messages);
    const std::lock_guard lock(kept.mutex);
    kept.texts.emplace_back(data->pMessage);
    return VK_FALSE;
}

vk::raii::Context open_loader() {
    try {
        return vk::raii::Context();
    } catch (const std::runtime_error&) {
        throw Error(no_loader);
    }
}

void require_validation_layer(const vk::raii::Context& loader) {
    const std::vector<vk::LayerProperties> layers = loader.enumerateInstanceLayerProperties();
    const bool found = std::any_of(layers.begin(), layers.end(), [](const vk::LayerProperties& layer) {
        return std::strcmp(layer.layerName, validation_layer) == 0;
    });
    if (!found)
        throw Error(
            "the Vulkan validation layer is asked for and not installed (Debian's package is "
            "vulkan-validationlayers)");
}

DeviceType type_of(vk::PhysicalDeviceType type) {
    switch (type) {
        case vk::PhysicalDeviceType::eDiscreteGpu:
            return DeviceType::discrete;
        case vk::PhysicalDeviceType::eIntegratedGpu:
            return DeviceType::integrated;
        case vk::PhysicalDeviceType::eVirtualGpu:
            return DeviceType::virtual_gpu;
        case vk::PhysicalDeviceType::eCpu:
            return DeviceType::cpu;
        default:
            return DeviceType::other;
    }
}

std::uint64_t local_memory(const vk::raii::PhysicalDevice& device) {
    const vk::PhysicalDeviceMemoryProperties memory = device.getMemoryProperties();
    std::uint64_t bytes = 0;
    for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i)
        if (memory.memoryHeaps[i].flags & vk::MemoryHeapFlagBits::eDeviceLocal) bytes += memory.memoryHeaps[i].size;
    return bytes;
}

vk::raii::Instance create(const vk::raii::Context& loader, const vk::InstanceCreateInfo& info) {
    try {
        return {loader, info};
    } catch (const vk::IncompatibleDriverError&) {
        throw Error(no_driver);
    }
}

void open_plain(Instance& instance) {
    instance.handle = create(instance.loader, vk::InstanceCreateInfo({}, &application));
}

void open_validated(Instance& instance) {
    require_validation_layer(instance.loader);
    const std::vector<const char*> extensions{VK_EXT_DEBUG_UTILS_EXTENSION_NAME,
                                              VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
    const vk::ValidationFeatureEnableEXT barriers = vk::ValidationFeatureEnableEXT::eSynchronizationValidation;
    using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
    using Kind = vk::DebugUtilsMessageTypeFlagBitsEXT;
    vk::DebugUtilsMessengerCreateInfoEXT listen({}, Severity::eWarning | Severity::eError,
                                                Kind::eValidation | Kind::ePerformance, collect,
                                                instance.messages.get());
    const vk::ValidationFeaturesEXT features(barriers, {}, &listen);
    vk::InstanceCreateInfo info({}, &application, validation_layer, extensions);
    info.setPNext(&features);
    instance.handle = create(instance.loader, info);
    instance.messenger = {instance.handle, listen};
}

}  // namespace

Instance make_instance(bool validation) {
    Instance instance{std::make_unique<Messages>(), open_loader()};
    attempt("open Vulkan", [&] { validation ? open_validated(instance) : open_plain(instance); });
    return instance;
}  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): it loses sight of the loader's owner

std::optional<std::uint32_t> pass_queue_family(const vk::raii::PhysicalDevice& device) {
    const std::vector<vk::QueueFamilyProperties> families = device.getQueueFamilyProperties();
    std::optional<std::uint32_t> chosen;
    for (std::uint32_t i = 0; i < families.size(); ++i) {
        if (!(families[i].queueFlags & vk::QueueFlagBits::eCompute)) continue;
        if (families[i].queueFlags & vk::QueueFlagBits::eGraphics) return i;
        if (!chosen) chosen = i;
    }
    return chosen;
}

DeviceDescription describe(const vk::raii::PhysicalDevice& device) {
    // Asking for the driver needs Vulkan 1.2 of the device, which is told by the older call.
    const vk::PhysicalDeviceProperties properties = device.getProperties();
    DeviceDescription description;
    description.name = properties.deviceName.data();
    description.type = type_of(properties.deviceType);
    description.api = {VK_API_VERSION_MAJOR(properties.apiVersion), VK_API_VERSION_MINOR(properties.apiVersion),
                       VK_API_VERSION_PATCH(properties.apiVersion)};
    const std::optional<std::uint32_t> family = pass_queue_family(device);
    description.compute = family.has_value();
    description.graphics =
        family && (device.getQueueFamilyProperties()[*family].queueFlags & vk::QueueFlagBits::eGraphics);
    constexpr vk::FormatFeatureFlags needed = vk::FormatFeatureFlagBits::eColorAttachmentBlend |
                                              vk::FormatFeatureFlagBits::eTransferSrc |
                                              vk::FormatFeatureFlagBits::eTransferDst;
    description.adds_floats = (device.getFormatProperties(target_format).optimalTilingFeatures & needed) == needed;
    description.largest_target =
        std::min(properties.limits.maxFramebufferWidth, properties.limits.maxFramebufferHeight);
    description.largest_storage_buffer_b = properties.limits.maxStorageBufferRange;
    description.memory_b = local_memory(device);
    if (properties.apiVersion >= VK_API_VERSION_1_2) {
        const auto chain = device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
        const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
        description.driver = std::string(driver.driverName.data()) + " " + driver.driverInfo.data();
    }
    return description;
}

Selection survey(const Instance& instance, std::string_view wanted) {
    try {
        std::vector<DeviceDescription> devices;
        for (const vk::raii::PhysicalDevice& device : vk::raii::PhysicalDevices(instance.handle))
            devices.push_back(describe(device));
        if (!devices.empty()) return select_device(std::move(devices), wanted);
        return {{}, std::nullopt, no_driver};
    } catch (const vk::Error& error) {
        return {{}, std::nullopt, std::string(no_driver) + ": " + error.what()};
    }
}

Selection survey(std::string_view wanted) {
    try {
        return survey(make_instance(false), wanted);
    } catch (const Error& error) {
        return {{}, std::nullopt, error.what()};
    }
}

}  // namespace waterlight::gpu
