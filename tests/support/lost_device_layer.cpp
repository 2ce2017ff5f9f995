// A Vulkan layer that loses the device: from the submission on whose number $WATERLIGHT_LOST_AFTER gives, every one
// returns VK_ERROR_DEVICE_LOST. So that a test sees what a driver's reset does. Of the images of a window, that on
// whose number $WATERLIGHT_SURFACE_LOST_AT gives is answered by VK_ERROR_SURFACE_LOST_KHR, once.
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace {

PFN_vkGetInstanceProcAddr next_instance = nullptr;
PFN_vkGetDeviceProcAddr next_device = nullptr;
PFN_vkQueueSubmit2 next_submit = nullptr;
PFN_vkAcquireNextImageKHR next_acquire = nullptr;

/// The link of the loader's chain of layers that this one takes and hands on.
template <class Info, class CreateInfo>
Info* link_of(const CreateInfo* create, VkStructureType type) {
    for (auto* info = static_cast<const Info*>(create->pNext); info; info = static_cast<const Info*>(info->pNext))
        if (info->sType == type && info->function == VK_LAYER_LINK_INFO) return const_cast<Info*>(info);
    return nullptr;
}

VkResult create_instance(const VkInstanceCreateInfo* create, const VkAllocationCallbacks* memory,
                         VkInstance* instance) {
    auto* link = link_of<VkLayerInstanceCreateInfo>(create, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    next_instance = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    return reinterpret_cast<PFN_vkCreateInstance>(next_instance(nullptr, "vkCreateInstance"))(create, memory, instance);
}

VkResult create_device(VkPhysicalDevice physical, const VkDeviceCreateInfo* create, const VkAllocationCallbacks* memory,
                       VkDevice* device) {
    auto* link = link_of<VkLayerDeviceCreateInfo>(create, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    next_device = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    const auto make = link->u.pLayerInfo->pfnNextGetInstanceProcAddr(nullptr, "vkCreateDevice");
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const VkResult result = reinterpret_cast<PFN_vkCreateDevice>(make)(physical, create, memory, device);
    if (result != VK_SUCCESS) return result;
    next_submit = reinterpret_cast<PFN_vkQueueSubmit2>(next_device(*device, "vkQueueSubmit2"));
    next_acquire = reinterpret_cast<PFN_vkAcquireNextImageKHR>(next_device(*device, "vkAcquireNextImageKHR"));
    return result;
}

VkResult submit(VkQueue queue, std::uint32_t count, const VkSubmitInfo2* submits, VkFence fence) {
    static int submitted = 0;
    const char* last = std::getenv("WATERLIGHT_LOST_AFTER");
    if (last && ++submitted > std::atoi(last)) return VK_ERROR_DEVICE_LOST;
    return next_submit(queue, count, submits, fence);
}

VkResult acquire(VkDevice device, VkSwapchainKHR chain, std::uint64_t timeout_ns, VkSemaphore semaphore, VkFence fence,
                 std::uint32_t* image) {
    static int acquired = 0;
    const char* lost = std::getenv("WATERLIGHT_SURFACE_LOST_AT");
    if (lost && ++acquired == std::atoi(lost)) return VK_ERROR_SURFACE_LOST_KHR;
    return next_acquire(device, chain, timeout_ns, semaphore, fence, image);
}

PFN_vkVoidFunction device_function(VkDevice device, const char* name) {
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0) return reinterpret_cast<PFN_vkVoidFunction>(device_function);
    if (std::strcmp(name, "vkQueueSubmit2") == 0) return reinterpret_cast<PFN_vkVoidFunction>(submit);
    if (std::strcmp(name, "vkAcquireNextImageKHR") == 0 && next_acquire)
        return reinterpret_cast<PFN_vkVoidFunction>(acquire);
    return next_device(device, name);
}

PFN_vkVoidFunction instance_function(VkInstance instance, const char* name) {
    if (std::strcmp(name, "vkGetInstanceProcAddr") == 0) return reinterpret_cast<PFN_vkVoidFunction>(instance_function);
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0) return reinterpret_cast<PFN_vkVoidFunction>(device_function);
    if (std::strcmp(name, "vkCreateInstance") == 0) return reinterpret_cast<PFN_vkVoidFunction>(create_instance);
    if (std::strcmp(name, "vkCreateDevice") == 0) return reinterpret_cast<PFN_vkVoidFunction>(create_device);
    return next_instance ? next_instance(instance, name) : nullptr;
}

}  // namespace

extern "C" VKAPI_ATTR VkResult VKAPI_CALL vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* version) {
    version->loaderLayerInterfaceVersion = 2;
    version->pfnGetInstanceProcAddr = instance_function;
    version->pfnGetDeviceProcAddr = device_function;
    version->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
