// A compute pass: one shader, the buffers it works on, its parameters.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gpu/buffer.hpp"
#include "gpu/context.hpp"

namespace waterlight::gpu {

/// The layout of a pass is always the same: storage buffers at set 0, bindings 0, 1, ..., then the buffers that it
/// reads as texels, one block of push constants, and the size of its workgroups as specialisation constants 0, 1 and 2,
/// written in the shader as `layout(local_size_x_id = 0, local_size_y_id = 1, local_size_z_id = 2) in;`.
struct PassSettings {
    std::string name;                      ///< for errors and timings
    std::span<const std::uint32_t> spirv;  ///< entry point "main"; must outlive the pass
    std::uint32_t buffers = 0;             ///< how many
    std::uint32_t push_bytes = 0;          ///< a multiple of 4, at most 128
    std::array<std::uint32_t, 3> workgroup{1, 1, 1};
    std::vector<Texels> texels = {};  ///< what stands in the buffers that are read as texels
};

class Pass {
  public:
    /// Throws Error where the driver refuses the shader.
    Pass(std::shared_ptr<Context> context, const PassSettings& settings);
    ~Pass();
    Pass(Pass&&) noexcept;
    Pass& operator=(Pass&&) noexcept;

    /// The buffers of bindings 0, 1, ..., all of them, then those read as texels; one may be both, where no invocation
    /// reads a texel that another writes. They must outlive their use. Not while commands run that use it.
    void bind(std::initializer_list<const Buffer*> buffers, std::initializer_list<const Buffer*> texels = {});

    struct Impl;
    const Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace waterlight::gpu
