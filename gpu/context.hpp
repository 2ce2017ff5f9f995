// An open device: what every buffer, pass and command list belongs to.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gpu/device.hpp"

namespace waterlight::gpu {

struct ContextSettings {
    std::string device = {};  ///< as select_device() takes it: empty, an index, or a part of a name
    bool staging = false;     ///< copy through staging areas even where host and device share a memory, as a test does
    bool validation = false;  ///< switch the Khronos validation layer on, with its checks of missing barriers
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
