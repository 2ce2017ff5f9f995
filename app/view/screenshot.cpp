#include "app/view/screenshot.hpp"

#include <fmt/format.h>

#include "export/atomic_file.hpp"
#include "export/png.hpp"

namespace waterlight {

void write_screenshot(SceneRenderer& renderer, const std::filesystem::path& file) {
    const std::vector<std::uint8_t> rgba = renderer.read_picture();
    ColourImage image{static_cast<int>(renderer.picture().width()), static_cast<int>(renderer.picture().height()), {}};
    const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
    image.pixels.reserve(3 * width * height);
    for (std::size_t row = height; row-- > 0;)
        for (std::size_t i = row * width; i < (row + 1) * width; ++i)
            image.pixels.insert(image.pixels.end(), {rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]});
    write_file(file, encode_png(image));
}

std::filesystem::path next_screenshot(const std::filesystem::path& folder) {
    for (int n = 1;; ++n) {
        std::filesystem::path file = folder / fmt::format("waterlight_{:03}.png", n);
        if (!std::filesystem::exists(file)) return file;
    }
}

}  // namespace waterlight
