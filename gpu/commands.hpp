// A list of copies, passes and draws that the device runs in order.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "gpu/buffer.hpp"
#include "gpu/context.hpp"
#include "gpu/pass.hpp"
#include "gpu/raster.hpp"

namespace waterlight::gpu {

/// How many invocations of a pass are wanted along each axis; rounded up to whole workgroups, so that a shader must
/// turn away those beyond.
using Extent = std::array<std::uint32_t, 3>;

/// What a raster pass draws: so many instances (strips of triangles, or lists of them), each of so many vertices.
struct Strips {
    std::uint32_t count = 0;
    std::uint32_t vertices = 0;
};

struct Timing {
    std::string pass;
    double seconds = 0;
};

/// Each entry waits for all before it, so that a pass sees what earlier passes and copies wrote. Record, run, record.
class Commands {
  public:
    /// Up to `timed_passes` dispatches and draws of each run are timed. Throws Error where the device refuses.
    explicit Commands(std::shared_ptr<Context> context, std::uint32_t timed_passes = 0);
    ~Commands();
    Commands(Commands&&) noexcept;
    Commands& operator=(Commands&&) noexcept;

    /// Makes what the host wrote into host() visible to passes.
    void upload(const Buffer& buffer);
    /// Makes what passes wrote visible in host() after run().
    void download(const Buffer& buffer);
    /// Sets every byte of the buffer to zero.
    void clear(const Buffer& buffer);
    /// Runs a pass over `extent` invocations; `parameters` is its block of push constants, push_bytes long.
    template <class Parameters>
    void dispatch(const Pass& pass, Extent extent, const Parameters& parameters) {
        static_assert(std::is_trivially_copyable_v<Parameters>);
        dispatch_bytes(pass, extent, std::as_bytes(std::span(&parameters, 1)));
    }
    /// The same for a pass without push constants.
    void dispatch(const Pass& pass, Extent extent) { dispatch_bytes(pass, extent, {}); }

    /// Sets every pixel, sample and depth to zero; once before the first draw into it.
    void clear(const Target& target);
    /// The same for depths only; colours become undefined, for passes that draw over all of them.
    void discard(const Target& target);
    /// Draws into the target, whose format and samples are those of the pass; `parameters` as those of dispatch().
    template <class Parameters>
    void draw(const Raster& raster, const Target& target, Strips strips, const Parameters& parameters) {
        static_assert(std::is_trivially_copyable_v<Parameters>);
        draw_bytes(raster, target, strips, std::as_bytes(std::span(&parameters, 1)));
    }
    /// The same for a pass without push constants.
    void draw(const Raster& raster, const Target& target, Strips strips) { draw_bytes(raster, target, strips, {}); }
    /// Makes of each pixel the mean of its samples; nothing where it has one.
    void resolve(const Target& target);
    /// Copies the pixels, row after row, to the start of a buffer that has room for them.
    void copy(const Target& target, const Buffer& buffer);

    /// Hands the list to the device, waits until it is done, and empties it. Throws Error where the device is lost.
    void run();
    /// Of the last run(), in order; empty where none were asked for or the device keeps no time.
    const std::vector<Timing>& timings() const;

    struct Impl;

  private:
    void clear_depth(const Target& target);
    void dispatch_bytes(const Pass& pass, Extent extent, std::span<const std::byte> parameters);
    void draw_bytes(const Raster& raster, const Target& target, Strips strips, std::span<const std::byte> parameters);
    std::unique_ptr<Impl> impl_;
};

}  // namespace waterlight::gpu
