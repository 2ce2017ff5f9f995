// Beams in a device's memory.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>

#include "caustics/beams.hpp"
#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"

namespace waterlight {

using Storage = std::optional<gpu::Buffer>;

/// Gives `buffer` room for so many bytes, at least 4.
inline void reserve(const std::shared_ptr<gpu::Context>& context, Storage& buffer, std::size_t bytes,
                    gpu::BufferUse use) {
    if (!buffer || buffer->bytes() < bytes) buffer.emplace(context, std::max<std::size_t>(bytes, 4), use);
}

/// Hands numbers over, one part after another.
inline void write(const std::shared_ptr<gpu::Context>& context, Storage& buffer,
                  std::initializer_list<std::span<const float>> parts, gpu::Commands& commands) {
    std::size_t count = 0;
    for (const std::span<const float> part : parts) count += part.size();
    reserve(context, buffer, sizeof(float) * count, gpu::BufferUse::from_host);
    float* to = buffer->host<float>().data();
    for (const std::span<const float> part : parts) to = std::ranges::copy(part, to).out;
    commands.upload(*buffer);
}

struct BeamBuffers {
    Storage corners;  ///< x, y, z, travel_x, travel_y, path and end_z of all corners, one after another
    Storage flux;     ///< of all beams

    void write(const std::shared_ptr<gpu::Context>& context, const Beams& b, gpu::Commands& commands) {
        waterlight::write(context, corners,
                          {b.x.values(), b.y.values(), b.z.values(), b.travel_x.values(), b.travel_y.values(),
                           b.path.values(), b.end_z.values()},
                          commands);
        waterlight::write(context, flux, {b.flux.values()}, commands);
    }
};

}  // namespace waterlight
