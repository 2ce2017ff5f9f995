#include "app/scene_image.hpp"

#include <algorithm>

namespace waterlight {

ColourImage scene_image(SceneRenderer& renderer) {
    const std::vector<std::uint8_t> pixels = renderer.read_picture();
    const int width = static_cast<int>(renderer.picture().width()),
              height = static_cast<int>(renderer.picture().height());
    ColourImage image{width, height, std::vector<std::uint8_t>(3 * pixels.size() / 4)};
    std::uint8_t* to = image.pixels.data();
    for (int j = height - 1; j >= 0; --j) {
        const std::uint8_t* from = pixels.data() + 4 * static_cast<std::ptrdiff_t>(j) * width;
        for (int i = 0; i < width; ++i, from += 4, to += 3) std::copy_n(from, 3, to);
    }
    return image;
}

}  // namespace waterlight
