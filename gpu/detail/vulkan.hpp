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

/// How many things a pass is bound to, in the order of their bindings.
struct BoundCounts {
    std::uint32_t uniforms = 0;  ///< of the buffers
    std::uint32_t buffers = 0;
    std::uint32_t targets = 0;
    std::vector<Texels> texels = {};
};

/// The buffers of a pass at set 0, bindings 0, 1, ..., then the pictures it reads, then the buffers it reads as texels,
/// and its block of push constants.
struct Binding {
    BoundCounts counts;
    std::uint32_t push_bytes = 0;
    vk::ShaderStageFlags stages;
    vk::raii::DescriptorSetLayout set_layout{nullptr};
    vk::raii::PipelineLayout layout{nullptr};
    vk::raii::DescriptorPool pool{nullptr};
    std::vector<vk::raii::BufferView> views;
    vk::raii::DescriptorSet set{nullptr};

    Binding() = default;
    Binding(const vk::raii::Device& device, BoundCounts bound, std::uint32_t bytes_pushed,
            vk::ShaderStageFlags used_in);
    /// Throws gpu::Error where the device does not read so many texels.
    void bind(Context& context, std::initializer_list<const Buffer*> all,
              std::initializer_list<const Target*> read = {}, std::initializer_list<const Buffer*> texels = {});
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
constexpr vk::Format depth_format = vk::Format::eD32Sfloat;

vk::Format vulkan_format(Format format);

/// Throws gpu::Error where the device cannot draw.
void require_drawing(const Context& context);

/// Of 1, 2, 4 or 8 samples: their bit is their number.
inline vk::SampleCountFlagBits sample_bit(std::uint32_t samples) { return vk::SampleCountFlagBits(samples); }

struct Image {
    vk::raii::DeviceMemory memory{nullptr};  // freed after the image that lies in it
    vk::raii::Image handle{nullptr};
    vk::raii::ImageView view{nullptr};
    vk::ImageSubresourceRange range;

    explicit operator bool() const { return *handle != vk::Image(); }
};

/// Between entries of a list each image is ready to be drawn into.
struct Target::Impl {
    std::shared_ptr<Context> context;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    Format format = Format::r32f;
    std::uint32_t samples = 1;
    Image pixels;
    Image many;   // of several samples a pixel; else empty
    Image depth;  // of so many samples, if wanted

    const Image& drawn() const { return many ? many : pixels; }
};

struct Raster::Impl {
    std::shared_ptr<Context> context;
    std::string name;
    Depth depth = Depth::none;
    Binding binding;
    std::vector<const Target*> read;
    vk::raii::Pipeline pipeline{nullptr};
};

}  // namespace waterlight::gpu
