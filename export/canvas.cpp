#include "export/canvas.hpp"

#include <algorithm>
#include <cassert>

namespace waterlight {

namespace {

constexpr Rgb ink_colour{38, 38, 38};

std::uint8_t towards_ink(std::uint8_t ink, int step, int steps) {
    return static_cast<std::uint8_t>(255 + (ink - 255) * step / steps);
}

}  // namespace

Canvas::Canvas(int width, int height, ColourMap map, Rgb missing)
    : image_{width, height, {}, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height, palette::paper)} {
    for (int i = 0; i < palette::map_steps; ++i) {
        image_.palette[i] = colour(map, static_cast<double>(i) / (palette::map_steps - 1));
    }
    image_.palette[palette::missing] = missing;
    constexpr int steps = palette::ink - palette::paper;
    for (int i = 0; i <= steps; ++i) {
        image_.palette[palette::paper + i] = {towards_ink(ink_colour.r, i, steps), towards_ink(ink_colour.g, i, steps),
                                              towards_ink(ink_colour.b, i, steps)};
    }
}

std::uint8_t* Canvas::row(int y) {
    assert(y >= 0 && y < image_.height);
    return image_.pixels.data() + static_cast<std::ptrdiff_t>(y) * image_.width;
}

void Canvas::fill(Rectangle area, std::uint8_t colour) {
    const int left = std::max(area.left, 0), right = std::min(area.right(), image_.width);
    const int top = std::max(area.top, 0), bottom = std::min(area.bottom(), image_.height);
    for (int y = top; y < bottom && left < right; ++y) std::fill(row(y) + left, row(y) + right, colour);
}

void Canvas::frame(Rectangle area, int thickness) {
    const int t = thickness;
    fill({area.left - t, area.top - t, area.width + 2 * t, t}, palette::ink);
    fill({area.left - t, area.bottom(), area.width + 2 * t, t}, palette::ink);
    fill({area.left - t, area.top, t, area.height}, palette::ink);
    fill({area.right(), area.top, t, area.height}, palette::ink);
}

void Canvas::write(const TextBlock& text, int left, int top) {
    constexpr int steps = palette::ink - palette::paper;
    for (int y = std::max(0, -top); y < std::min(text.height, image_.height - top); ++y) {
        const std::uint8_t* coverage = text.coverage.data() + static_cast<std::ptrdiff_t>(y) * text.width;
        std::uint8_t* to = row(top + y);
        for (int x = std::max(0, -left); x < std::min(text.width, image_.width - left); ++x) {
            if (coverage[x] == 0) continue;
            to[left + x] = static_cast<std::uint8_t>(palette::paper + (coverage[x] * steps + 127) / 255);
        }
    }
}

}  // namespace waterlight
