// A storage buffer of a pass.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>

#include "gpu/context.hpp"

namespace waterlight::gpu {

/// Who touches the buffer besides passes.
enum class BufferUse {
    device,     ///< nobody
    from_host,  ///< the host writes it: fill host(), then Commands::upload()
    to_host,    ///< the host reads it: Commands::download(), run(), then read host()
    both        ///< the host writes and reads it
};

/// What stands in a buffer that a shader reads as texels (`samplerBuffer`): one, two or four numbers. A device that is
/// a CPU reads a storage buffer one invocation at a time, and the texels of several at once.
enum class Texels { r32f, rg32f, rgba32f };

/// Storage that passes read and write. Where device and host share one memory, host() is that memory itself and nothing
/// is ever copied; elsewhere it is a staging area.
class Buffer {
  public:
    /// `bytes` > 0. The contents are undefined at first. Throws Error where the device cannot hold so much.
    Buffer(std::shared_ptr<Context> context, std::size_t bytes, BufferUse use);
    ~Buffer();
    Buffer(Buffer&&) noexcept;
    Buffer& operator=(Buffer&&) noexcept;

    std::size_t bytes() const;
    /// The host's view, as many whole T as fit. Not for BufferUse::device.
    template <class T>
    std::span<T> host() const {
        static_assert(std::is_trivially_copyable_v<T>);
        return {static_cast<T*>(mapped()), bytes() / sizeof(T)};
    }

    struct Impl;
    const Impl& impl() const { return *impl_; }

  private:
    void* mapped() const;
    std::unique_ptr<Impl> impl_;
};

}  // namespace waterlight::gpu
