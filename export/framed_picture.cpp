#include "export/framed_picture.hpp"

#include <algorithm>

namespace waterlight {

namespace {

ColourImage in_colours(const IndexedImage& image) {
    ColourImage colours{image.width, image.height, std::vector<std::uint8_t>(3 * image.pixels.size())};
    for (std::size_t n = 0; n < image.pixels.size(); ++n) {
        const Rgb c = image.palette[image.pixels[n]];
        std::copy_n(std::array{c.r, c.g, c.b}.data(), 3, colours.pixels.data() + 3 * n);
    }
    return colours;
}

}  // namespace

ColourImage framed_picture(const ColourImage& picture, const PictureSettings& settings, Clipped clipped) {
    const Legend legend(settings, picture.width, picture.height, 0, clipped);
    Canvas canvas(legend.canvas_width(), legend.canvas_height(), settings.map, settings.missing);
    legend.draw(canvas);
    ColourImage framed = in_colours(canvas.take());
    const Rectangle place = legend.picture();
    for (int y = 0; y < picture.height; ++y)
        std::copy_n(
            picture.pixels.data() + 3 * static_cast<std::ptrdiff_t>(y) * picture.width, 3 * picture.width,
            framed.pixels.data() + 3 * (static_cast<std::ptrdiff_t>(place.top + y) * framed.width + place.left));
    return framed;
}

}  // namespace waterlight
