// An open device: what every buffer, pass and command list belongs to.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/device.hpp"

// Vulkan's own handles, which window systems give and take.
struct VkInstance_T;
struct VkPhysicalDevice_T;

namespace waterlight::gpu {

/// What it takes to show pictures in a window, told by whoever opens windows.
struct WindowSystem {
    std::vector<std::string> instance_extensions;
    /// Whether a queue of this family of the device can show pictures.
    std::function<bool(VkInstance_T*, VkPhysicalDevice_T*, std::uint32_t)> presents;
};

struct ContextSettings {
    std::string device = {};  ///< as select_device() takes it: empty, an index, or a part of a name
    bool staging = false;     ///< copy through staging areas even where host and device share a memory, as a test does
    bool validation = false;  ///< switch the Khronos validation layer on, with its checks of missing barriers
    std::optional<WindowSystem> window_system = {};  ///< for a Presenter: only devices that can show pictures there
};

/// One device with one queue. One thread at a time uses a context and what belongs to it.
class Context {
  public:
    /// Throws Error without a loader, a driver or a fitting device, or where the validation layer is asked for and is
    /// not installed.
    explicit Context(const ContextSettings& settings = {});
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    const DeviceDescription& device() const;
    /// Every device that was there, and why this one.
    const Selection& selection() const;
    /// What the validation layer has said so far, warnings and errors; empty where all is well or it is off.
    std::vector<std::string> validation_messages() const;

    struct Impl;
    Impl& impl() { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace waterlight::gpu
