// What an interface draws over a picture: coloured triangles, some of them cut out of an atlas of letters.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace waterlight::gpu {

struct InterfaceCorner {
    float x = 0, y = 0;      ///< pixels of the window, y counted downwards
    float u = 0, v = 0;      ///< of the atlas, in [0, 1]; one texel on one pixel is assumed
    std::uint32_t rgba = 0;  ///< sRGB and opacity, red in the lowest byte
};

/// Triangles that are drawn within one rectangle.
struct InterfaceBatch {
    std::array<std::int32_t, 2> clip_from{}, clip_to{};  ///< pixels
    std::uint32_t first_index = 0, indices = 0;
};

/// Later batches lie over earlier ones.
struct InterfaceDrawing {
    std::vector<InterfaceCorner> corners;
    std::vector<std::uint32_t> indices;  ///< of corners, three a triangle
    std::vector<InterfaceBatch> batches;
};

/// Opacity of letters, rows from the top down; a multiple of 4 values.
struct InterfaceAtlas {
    std::uint32_t width = 0, height = 0;
    std::span<const std::uint8_t> opacity;
};

}  // namespace waterlight::gpu
