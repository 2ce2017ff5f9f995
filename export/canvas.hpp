// A sheet of paper to draw a picture and its legend on.
#pragma once

#include <cstdint>
#include <utility>

#include "export/colour_map.hpp"
#include "export/png.hpp"
#include "export/text.hpp"

namespace waterlight {

/// How a canvas uses its 256 colours: the steps of a colour map, one for a missing value, and a ramp from paper to ink
/// for smooth letters.
namespace palette {
constexpr int map_steps = 240;
constexpr std::uint8_t missing = 240;
constexpr std::uint8_t paper = 241;
constexpr std::uint8_t ink = 255;
}  // namespace palette

/// Pixels from (left, top) on; y grows downwards.
struct Rectangle {
    int left = 0, top = 0, width = 0, height = 0;
    int right() const { return left + width; }
    int bottom() const { return top + height; }
};

class Canvas {
  public:
    /// White paper. A missing value has the colour `missing`.
    Canvas(int width, int height, ColourMap map, Rgb missing);

    /// All these clip at the edges of the canvas.
    void fill(Rectangle area, std::uint8_t colour);
    /// A line of `thickness` pixels around the outside of `area`.
    void frame(Rectangle area, int thickness);
    /// The text with its top left corner at (left, top), on paper.
    void write(const TextBlock& text, int left, int top);

    std::uint8_t* row(int y);
    /// Gives the picture away.
    IndexedImage take() { return std::move(image_); }

  private:
    IndexedImage image_;
};

}  // namespace waterlight
