#include "export/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "export/text.hpp"

namespace waterlight {

namespace {

constexpr std::array<Rgb, 5> pen_colours{Rgb{38, 38, 38}, {222, 222, 222}, {150, 150, 150}, {0, 96, 160}, {192, 64, 0}};
constexpr int shades = 51;  // of each pen, from paper to its colour: 5 x 51 fit a palette
constexpr double dash = 8, gap = 5;

Rgb colour_of(Pen pen) { return pen_colours[static_cast<std::size_t>(pen)]; }

std::string hex(Rgb c) { return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b); }

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '&')
            safe += "&amp;";
        else if (c == '<')
            safe += "&lt;";
        else if (c == '>')
            safe += "&gt;";
        else
            safe += c;
    }
    return safe;
}

/// The picture in the making: each pixel is a shade of the pen that covers it most.
class Raster {
  public:
    Raster(int width, int height)
        : image_{width, height, {}, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height, 0)} {
        for (std::size_t p = 0; p < pen_colours.size(); ++p)
            for (int s = 0; s < shades; ++s) image_.palette[p * shades + s] = shade(pen_colours[p], s);
    }

    /// `coverage`, at the centre of each pixel of the box, is at most 1.
    template <class Coverage>
    void stroke(glm::dvec2 low, glm::dvec2 high, Pen pen, Coverage coverage) {
        const int left = std::max(0, static_cast<int>(low.x)), top = std::max(0, static_cast<int>(low.y));
        const int right = std::min(image_.width, static_cast<int>(high.x) + 1);
        const int bottom = std::min(image_.height, static_cast<int>(high.y) + 1);
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) cover(x, y, pen, coverage(glm::dvec2(x + 0.5, y + 0.5)));
    }

    IndexedImage take() { return std::move(image_); }

  private:
    static Rgb shade(Rgb c, int s) {
        const auto mix = [s](std::uint8_t v) { return static_cast<std::uint8_t>(255 + (v - 255) * s / (shades - 1)); };
        return {mix(c.r), mix(c.g), mix(c.b)};
    }

    void cover(int x, int y, Pen pen, double coverage) {
        if (coverage <= 0) return;
        std::uint8_t& pixel = image_.pixels[static_cast<std::size_t>(y) * image_.width + x];
        const int now = static_cast<int>(std::lround(std::min(coverage, 1.0) * (shades - 1)));
        // Where it covers half or more it hides what was there; a soft edge does not brighten it.
        if (2 * now < shades && now < pixel % shades) return;
        pixel = static_cast<std::uint8_t>(static_cast<int>(pen) * shades + now);
    }

    IndexedImage image_;
};

void draw(const DrawnLine& line, Raster& raster) {
    const glm::dvec2 along = line.to - line.from;
    const double length = glm::length(along), reach = line.width / 2 + 1;
    const glm::dvec2 direction = length > 0 ? along / length : glm::dvec2(1, 0);
    raster.stroke(glm::min(line.from, line.to) - reach, glm::max(line.from, line.to) + reach, line.pen,
                  [&](glm::dvec2 at) {
                      const double t = glm::dot(at - line.from, direction);
                      if (line.dashed && std::fmod(std::max(t, 0.0), dash + gap) > dash) return 0.0;
                      const glm::dvec2 nearest = line.from + std::clamp(t, 0.0, length) * direction;
                      return line.width / 2 + 0.5 - glm::distance(at, nearest);
                  });
}

void draw(const DrawnDisc& disc, Raster& raster) {
    raster.stroke(disc.centre - disc.radius - 1.0, disc.centre + disc.radius + 1.0, disc.pen,
                  [&](glm::dvec2 at) { return disc.radius + 0.5 - glm::distance(at, disc.centre); });
}

void draw(const DrawnText& words, Raster& raster) {
    const TextBlock block = render_text(words.text, words.size, words.bold);
    const double before = words.anchor == Anchor::start    ? 0
                          : words.anchor == Anchor::middle ? block.width / 2
                                                           : block.width;
    const glm::dvec2 extent(block.width, block.height), back(before, block.height / 2);
    const auto ink = [&](int column, int row) {
        const bool inside = column >= 0 && column < block.width && row >= 0 && row < block.height;
        return inside ? block.coverage[static_cast<std::size_t>(row) * block.width + column] / 255.0 : 0.0;
    };
    const glm::dvec2 at = glm::floor(words.at);
    if (!words.upward) {
        const glm::dvec2 corner = at - back;
        raster.stroke(corner, corner + extent, Pen::ink, [&](glm::dvec2 p) {
            return ink(static_cast<int>(std::floor(p.x - corner.x)), static_cast<int>(std::floor(p.y - corner.y)));
        });
        return;
    }
    // A quarter turn: along the words is up, down their letters is to the right.
    const glm::dvec2 corner(at.x - back.y, at.y + back.x);
    raster.stroke({corner.x, corner.y - extent.x}, {corner.x + extent.y, corner.y}, Pen::ink, [&](glm::dvec2 p) {
        return ink(static_cast<int>(std::floor(corner.y - p.y)), static_cast<int>(std::floor(p.x - corner.x)));
    });
}

std::string svg_of(const DrawnLine& l) {
    return fmt::format(
        "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"{}\" stroke-width=\"{}\""
        " stroke-linecap=\"round\"{}/>\n",
        l.from.x, l.from.y, l.to.x, l.to.y, hex(colour_of(l.pen)), l.width,
        l.dashed ? fmt::format(" stroke-dasharray=\"{} {}\"", dash, gap) : "");
}

std::string svg_of(const DrawnDisc& d) {
    return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" fill=\"{}\"/>\n", d.centre.x, d.centre.y, d.radius,
                       hex(colour_of(d.pen)));
}

std::string svg_of(const DrawnText& t) {
    const char* const anchors[] = {"start", "middle", "end"};
    const std::string turn =
        t.upward ? fmt::format(" transform=\"rotate(-90 {:.2f} {:.2f})\"", t.at.x, t.at.y) : std::string();
    return fmt::format(
        "<text x=\"{:.2f}\" y=\"{:.2f}\" dy=\"0.35em\" font-size=\"{}\" text-anchor=\"{}\"{}{}>{}</text>\n", t.at.x,
        t.at.y, t.size, anchors[static_cast<int>(t.anchor)], t.bold ? " font-weight=\"bold\"" : "", turn,
        escaped(t.text));
}

}  // namespace

std::string svg_of(const Drawing& drawing) {
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"Arial, Helvetica, sans-serif\" fill=\"{2}\">\n<rect width=\"{0}\" height=\"{1}\" "
        "fill=\"white\"/>\n",
        drawing.width, drawing.height, hex(colour_of(Pen::ink)));
    for (const DrawnLine& line : drawing.lines) svg += svg_of(line);
    for (const DrawnDisc& disc : drawing.discs) svg += svg_of(disc);
    for (const DrawnText& text : drawing.texts) svg += svg_of(text);
    return svg + "</svg>\n";
}

IndexedImage image_of(const Drawing& drawing) {
    Raster raster(drawing.width, drawing.height);
    for (const DrawnLine& line : drawing.lines) draw(line, raster);
    for (const DrawnDisc& disc : drawing.discs) draw(disc, raster);
    for (const DrawnText& text : drawing.texts) draw(text, raster);
    return raster.take();
}

}  // namespace waterlight
