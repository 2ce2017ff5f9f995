// A raster pass: draws triangles into a target, each fragment blended with what is there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gpu/buffer.hpp"
#include "gpu/context.hpp"

namespace waterlight::gpu {

/// Of a pixel: one or four numbers, 32-bit or 16-bit floats, or bytes that stand for [0, 1].
enum class Format { r32f, rgba16f, rgba32f, rgba8 };

struct TargetSettings {
    Format format = Format::r32f;
    std::uint32_t samples = 1;  ///< of a pixel: 1, 2, 4 or 8; where the device has fewer, its most
    bool depth = false;         ///< whether it has depths (32-bit floats) beside its colours
};

/// A picture. Row 0 is the one of the smallest y. Of several samples a pixel, draws go into the samples, and what is
/// copied and presented are the pixels that Commands::resolve() makes of them.
class Target {
  public:
    /// Sides >= 1. The contents are undefined at first. Throws Error where the device cannot draw into such pixels, or
    /// not into so many.
    Target(std::shared_ptr<Context> context, std::uint32_t width, std::uint32_t height,
           const TargetSettings& settings = {});
    ~Target();
    Target(Target&&) noexcept;
    Target& operator=(Target&&) noexcept;

    std::uint32_t width() const;
    std::uint32_t height() const;
    Format format() const;
    std::uint32_t samples() const;  ///< as made
    std::size_t bytes() const;      ///< of all pixels

    struct Impl;
    const Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

/// What of a draw's vertices makes triangles.
enum class Topology {
    strip,     ///< each instance a strip, either way round
    triangles  ///< each three vertices one
};

/// What becomes of a fragment, colour by colour.
enum class Blend {
    add,      ///< added to what is there
    replace,  ///< in its place
    over      ///< added to (1 - its alpha) of what is there
};

/// Depths grow towards the eye: 0 is farthest, and what clear() leaves.
enum class Depth {
    none,         ///< not looked at
    test,         ///< fragments nearer than what is there, or as near, are drawn
    test_and_set  ///< and their depth is kept
};

/// The layout of a raster pass: buffers at set 0, bindings 0, 1, ..., the first of them uniform blocks, the others
/// storage; then the targets that it reads, as `texture2D` or, of several samples, `texture2DMS`; then the
/// buffers that it reads as texels; and one block of push constants. Its shaders only read, and both see all. Vertices
/// are pulled from the buffers by gl_VertexIndex and gl_InstanceIndex. The fragment shader's output 0 is a pixel of the
/// target's format. Fragments of one draw are blended in the order of instances.
struct RasterSettings {
    std::string name;                             ///< for errors and timings
    std::span<const std::uint32_t> vertex_spirv;  ///< entry point "main"; both must outlive the pass
    std::span<const std::uint32_t> fragment_spirv;
    std::uint32_t buffers = 0;               ///< how many, >= 1
    std::uint32_t push_bytes = 0;            ///< a multiple of 4, at most 128
    std::vector<std::uint32_t> constants{};  ///< specialisation constants 0, 1, ... of both shaders
    std::uint32_t uniforms = 0;              ///< how many of the buffers are uniform blocks, each at most 16 KiB
    std::uint32_t targets = 0;               ///< how many are read
    Topology topology = Topology::strip;
    Blend blend = Blend::add;
    Depth depth = Depth::none;
    Format format = Format::r32f;     ///< of what it draws into
    std::uint32_t samples = 1;        ///< of the same, as Target::samples() says
    std::vector<Texels> texels = {};  ///< buffers read as texels, after the pictures
};

class Raster {
  public:
    /// Throws Error where the device cannot draw so or the driver refuses a shader.
    Raster(std::shared_ptr<Context> context, const RasterSettings& settings);
    ~Raster();
    Raster(Raster&&) noexcept;
    Raster& operator=(Raster&&) noexcept;

    /// The buffers of bindings 0, 1, ..., all of them, then the targets, then the buffers read as texels. They
    /// must outlive their use. Not while commands run that use it.
    void bind(std::initializer_list<const Buffer*> buffers, std::initializer_list<const Target*> targets = {},
              std::initializer_list<const Buffer*> texels = {});

    struct Impl;
    const Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace waterlight::gpu
