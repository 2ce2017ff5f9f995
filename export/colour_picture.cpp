#include "export/colour_picture.hpp"

#include <algorithm>
#include <cmath>

#include "export/atomic_file.hpp"
#include "export/png.hpp"

namespace waterlight {

namespace {

constexpr int curve_steps = 4096;

/// sRGB's curve over [0, 1].
std::array<std::uint8_t, curve_steps + 1> srgb_curve() {
    std::array<std::uint8_t, curve_steps + 1> curve{};
    for (int i = 0; i <= curve_steps; ++i) {
        const double linear = static_cast<double>(i) / curve_steps;
        const double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
        curve[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(std::lround(255 * encoded));
    }
    return curve;
}

}  // namespace

void write_colour_picture(const std::filesystem::path& path, const ColourFields& fields) {
    static const std::array<std::uint8_t, curve_steps + 1> curve = srgb_curve();
    const int width = fields.field[0]->nx(), height = fields.field[0]->ny();
    ColourImage image{width, height, std::vector<std::uint8_t>(3 * fields.field[0]->size())};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto scale = static_cast<float>(curve_steps / fields.full[c]);
        for (int j = 0; j < height; ++j) {
            const float* from = fields.field[c]->row(height - 1 - j);
            std::uint8_t* to = image.pixels.data() + 3 * static_cast<std::ptrdiff_t>(j) * width + c;
            for (int i = 0; i < width; ++i) {
                const float step = scale * from[i];
                to[3 * i] = curve[static_cast<std::size_t>(step > 0 ? std::min(step, float(curve_steps)) : 0)];
            }
        }
    }
    write_file(path, encode_png(image));
}

}  // namespace waterlight
