// A raster pass: draws triangles into a target of floats, each fragment added to what is there.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gpu/buffer.hpp"
#include "gpu/context.hpp"

namespace waterlight::gpu {

/// A picture of 32-bit floats, one a pixel. Row 0 is the one of the smallest y.
class Target {
  public:
    /// Sides >= 1. The contents are undefined at first. Throws Error where the device cannot draw into floats, or not
    /// into so many.
    Target(std::shared_ptr<Context> context, std::uint32_t width, std::uint32_t height);
    ~Target();
    Target(Target&&) noexcept;
    Target& operator=(Target&&) noexcept;

    std::uint32_t width() const;
    std::uint32_t height() const;

    struct Impl;
    const Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

/// The layout of a raster pass: storage buffers at set 0, bindings 0, 1, ..., which its shaders only read, and one
/// block of push constants, seen by both shaders. Vertices are pulled from the buffers by gl_VertexIndex and
/// gl_InstanceIndex; each instance is a strip of triangles, either way round. The fragment shader's output 0 is a
/// float. Fragments of one draw are added in the order of instances.
struct RasterSettings {
    std::string name;                             ///< for errors and timings
    std::span<const std::uint32_t> vertex_spirv;  ///< entry point "main"; both must outlive the pass
    std::span<const std::uint32_t> fragment_spirv;
    std::uint32_t buffers = 0;               ///< how many
    std::uint32_t push_bytes = 0;            ///< a multiple of 4, at most 128
    std::vector<std::uint32_t> constants{};  ///< specialisation constants 0, 1, ... of the fragment shader
};

class Raster {
  public:
    /// Throws Error where the device cannot draw into floats or the driver refuses a shader.
    Raster(std::shared_ptr<Context> context, const RasterSettings& settings);
    ~Raster();
    Raster(Raster&&) noexcept;
    Raster& operator=(Raster&&) noexcept;

    /// The buffers of bindings 0, 1, ..., all of them. They must outlive their use. Not while commands run that use it.
    void bind(std::initializer_list<const Buffer*> buffers);

    struct Impl;
    const Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace waterlight::gpu
