// The PNG file format, for the kinds of picture that a run writes.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace waterlight {

struct Rgb {
    std::uint8_t r = 0, g = 0, b = 0;
    bool operator==(const Rgb&) const = default;
};

/// A picture of at most 256 colours, the top row first.
struct IndexedImage {
    int width = 0;
    int height = 0;
    std::array<Rgb, 256> palette{};
    std::vector<std::uint8_t> pixels;
};

/// 16-bit grey values, the top row first.
struct GreyImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint16_t> pixels;
};

/// Red, green and blue of each pixel, the top row first.
struct ColourImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;
};

/// Keyword (Latin-1, at most 79 characters) and text of a tEXt chunk.
using PngText = std::map<std::string, std::string>;

/// The bytes of a .png file. Quick rather than small: one filter, compression level 1. All assert width, height >= 1.
std::string encode_png(const IndexedImage& image, const PngText& text = {});
std::string encode_png(const GreyImage& image, const PngText& text = {});
std::string encode_png(const ColourImage& image, const PngText& text = {});

}  // namespace waterlight
