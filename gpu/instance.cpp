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

void open_plain(Instance& instance, const std::vector<const char*>& extensions) {
    instance.handle = create(instance.loader, vk::InstanceCreateInfo({}, &application, {}, extensions));
}

void open_validated(Instance& instance, std::vector<const char*> extensions) {
    require_validation_layer(instance.loader);
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
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

Instance make_instance(const ContextSettings& settings) {
    Instance instance{std::make_unique<Messages>(), open_loader()};
    std::vector<const char*> extensions;
    if (settings.window_system)
        for (const std::string& name : settings.window_system->instance_extensions) extensions.push_back(name.c_str());
    attempt("open Vulkan",
            [&] { settings.validation ? open_validated(instance, extensions) : open_plain(instance, extensions); });
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
    description.most_texels = properties.limits.maxTexelBufferElements;
    description.memory_b = local_memory(device);
    if (properties.apiVersion >= VK_API_VERSION_1_2) {
        const auto chain = device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
        const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
        description.driver = std::string(driver.driverName.data()) + " " + driver.driverInfo.data();
    }
    return description;
}

bool presents(const Instance& instance, const vk::raii::PhysicalDevice& device, const WindowSystem& system) {
    const std::vector<vk::ExtensionProperties> extensions = device.enumerateDeviceExtensionProperties();
    const bool swaps = std::any_of(extensions.begin(), extensions.end(), [](const vk::ExtensionProperties& extension) {
        return std::strcmp(extension.extensionName, VK_KHR_SWAPCHAIN_EXTENSION_NAME) == 0;
    });
    const std::optional<std::uint32_t> family = pass_queue_family(device);
    return swaps && family &&
           system.presents(static_cast<VkInstance>(*instance.handle), static_cast<VkPhysicalDevice>(*device), *family);
}

Selection survey(const Instance& instance, const ContextSettings& settings) {
    try {
        std::vector<DeviceDescription> devices;
        for (const vk::raii::PhysicalDevice& device : vk::raii::PhysicalDevices(instance.handle)) {
            devices.push_back(describe(device));
            if (settings.window_system) devices.back().presents = presents(instance, device, *settings.window_system);
        }
        if (!devices.empty()) return select_device(std::move(devices), settings.device);
        return {{}, std::nullopt, no_driver};
    } catch (const vk::Error& error) {
        return {{}, std::nullopt, std::string(no_driver) + ": " + error.what()};
    }
}

Selection survey(std::string_view wanted) {
    try {
        const ContextSettings settings{.device = std::string(wanted)};
        return survey(make_instance(settings), settings);
    } catch (const Error& error) {
        return {{}, std::nullopt, error.what()};
    }
}

}  // namespace waterlight::gpu
