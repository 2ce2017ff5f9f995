// What the .cpp files of this folder share: Vulkan-Hpp itself, and what lies behind the public classes. Not public.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "gpu/context.hpp"
#include "gpu/device.hpp"
#include "gpu/error.hpp"
#include "gpu/pass.hpp"
#include "gpu/raster.hpp"

namespace waterlight::gpu {

/// Runs `work`; a Vulkan error leaves as gpu::Error "cannot `doing`: cause".
template <class Work>
auto attempt(std::string_view doing, Work&& work) {
    try {
        return std::forward<Work>(work)();
    } catch (const vk::DeviceLostError& error) {
        throw Error("the Vulkan device was lost, and cannot " + std::string(doing) + " (" + error.what() +
                    "): its driver was reset, or it was removed");
    } catch (const vk::Error& error) {
        throw Error("cannot " + std::string(doing) + ": " + error.what());
    }
}

/// What the validation layer said; it may speak from any thread.
struct Messages {
    std::mutex mutex;
    std::vector<std::string> texts;
};

struct Instance {
    std::unique_ptr<Messages> messages;  // outlives the instance, which speaks to it until its end
    vk::raii::Context loader;
    vk::raii::Instance handle{nullptr};
    vk::raii::DebugUtilsMessengerEXT messenger{nullptr};
};

/// Throws gpu::Error without a loader, without a driver, or where the layer or an extension is asked for and absent.
Instance make_instance(const ContextSettings& settings);

DeviceDescription describe(const vk::raii::PhysicalDevice& device);

/// Whether the queue that passes run on shows pictures in the window system.
bool presents(const Instance& instance, const vk::raii::PhysicalDevice& device, const WindowSystem& system);

/// As survey() of gpu/device.hpp, through an instance that is open.
Selection survey(const Instance& instance, const ContextSettings& settings);

/// The queue family that passes run on: one that has graphics beside compute, if there is one.
std::optional<std::uint32_t> pass_queue_family(const vk::raii::PhysicalDevice& device);

struct Context::Impl {
    Instance instance;
    Selection selection;
    vk::raii::PhysicalDevice physical{nullptr};
    std::uint32_t queue_family = 0;
    vk::raii::Device device{nullptr};
    vk::raii::Queue queue{nullptr};
    vk::raii::CommandPool pool{nullptr};
    vk::PhysicalDeviceMemoryProperties memory;
    double timestamp_period_ns = 0;  // 0: the queue keeps no time
    bool unified = false;            // host and device share one memory, so that nothing need be staged

    explicit Impl(Instance opened) : instance(std::move(opened)) {}

    /// The first memory type within `allowed` that has every flag of the earliest wish that any type can meet.
    std::uint32_t memory_type(std::uint32_t allowed, std::initializer_list<vk::MemoryPropertyFlags> wishes) const;
};

struct Buffer::Impl {
    struct Block {
        vk::raii::DeviceMemory memory{nullptr};  // freed after the buffer that lies in it
        vk::raii::Buffer handle{nullptr};
    };
    std::shared_ptr<Context> context;
    std::size_t bytes = 0;
    BufferUse use = BufferUse::device;
    Block main;
    Block staging;  // empty where the host reaches `main` itself
    void* mapped = nullptr;

    bool staged() const { return *staging.handle != vk::Buffer(); }
};

/// The storage buffers of a pass at set 0, bindings 0, 1, ..., and its block of push constants.
struct Binding {
    std::uint32_t buffers = 0;
    std::uint32_t push_bytes = 0;
    vk::ShaderStageFlags stages;
    vk::raii::DescriptorSetLayout set_layout{nullptr};
    vk::raii::PipelineLayout layout{nullptr};
    vk::raii::DescriptorPool pool{nullptr};
    vk::raii::DescriptorSet set{nullptr};

    Binding() = default;
    Binding(const vk::raii::Device& device, std::uint32_t buffer_count, std::uint32_t bytes_pushed,
            vk::ShaderStageFlags used_in);
    void bind(const vk::raii::Device& device, std::initializer_list<const Buffer*> all) const;
    void use(const vk::raii::CommandBuffer& list, vk::PipelineBindPoint point,
             std::span<const std::byte> parameters) const;
};

struct Pass::Impl {
    std::shared_ptr<Context> context;
    PassSettings settings;
    Binding binding;
    vk::raii::Pipeline pipeline{nullptr};
};

constexpr vk::Format target_format = vk::Format::eR32Sfloat;

struct Target::Impl {
    static constexpr vk::ImageSubresourceRange whole{vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1};
    std::shared_ptr<Context> context;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    vk::raii::DeviceMemory memory{nullptr};  // freed after the image that lies in it
    vk::raii::Image image{nullptr};          // between entries of a list ready to be drawn into
    vk::raii::ImageView view{nullptr};
};

struct Raster::Impl {
    std::shared_ptr<Context> context;
    std::string name;
    Binding binding;
    vk::raii::Pipeline pipeline{nullptr};
};

}  // namespace waterlight::gpu
