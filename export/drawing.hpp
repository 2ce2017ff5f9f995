// Lines, discs and words on white paper, the same as SVG and as PNG.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "export/png.hpp"

namespace waterlight {

/// What a stroke is for; its colour follows.
enum class Pen { ink, grid, mark, accent, limit };

enum class Anchor { start, middle, end };

struct DrawnLine {
    glm::dvec2 from{0, 0}, to{0, 0};
    double width = 1;
    Pen pen = Pen::ink;
    bool dashed = false;
};

struct DrawnDisc {
    glm::dvec2 centre{0, 0};
    double radius = 1;
    Pen pen = Pen::ink;
};

/// Words in ASCII; `at` lies on their middle line, at their start, middle or end.
struct DrawnText {
    glm::dvec2 at{0, 0};
    std::string text;
    int size = 16;
    Anchor anchor = Anchor::start;
    bool upward = false;  ///< read from below
    bool bold = false;
};

/// In pixels from the top left corner; later strokes lie over earlier ones.
struct Drawing {
    int width = 0;
    int height = 0;
    std::vector<DrawnLine> lines;
    std::vector<DrawnDisc> discs;
    std::vector<DrawnText> texts;
};

std::string svg_of(const Drawing& drawing);
/// With smooth edges. One thread at a time (see render_text).
IndexedImage image_of(const Drawing& drawing);

}  // namespace waterlight
