// Words as pixels, in VTK's own embedded font: needs no font package, window system or OpenGL.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace waterlight {

/// Coverage 0 to 255, the top row first. Texts of one size have one height and one baseline.
struct TextBlock {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> coverage;
};

/// `text` is ASCII and the UTF-8 signs for squared, cubed and degrees; size_px >= 8 is the font's. VTK's font cache is
/// shared: not to be called by two threads at once.
TextBlock render_text(const std::string& text, int size_px, bool bold = false);

}  // namespace waterlight
