#include "export/text.hpp"

#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cassert>
#include <string_view>
#include <utility>

namespace waterlight {

namespace {

/// A piece of text in letters that the embedded font has.
struct Run {
    std::string letters;
    bool raised = false;
};

/// The font ends with ASCII: squared, cubed and degrees become raised letters.
std::vector<Run> runs_of(const std::string& text) {
    constexpr std::pair<std::string_view, char> signs[] = {{"\u00b2", '2'}, {"\u00b3", '3'}, {"\u00b0", 'o'}};
    std::vector<Run> runs(1);
    for (std::size_t i = 0; i < text.size();) {
        const auto is_here = [&](const auto& sign) { return text.compare(i, sign.first.size(), sign.first) == 0; };
        const auto* const sign = std::ranges::find_if(signs, is_here);
        if (sign != std::end(signs)) {
            runs.push_back({std::string(1, sign->second), true});
            runs.push_back({});
            i += sign->first.size();
        } else {
            runs.back().letters += text[i++];
        }
    }
    std::erase_if(runs, [](const Run& run) { return run.letters.empty(); });
    return runs;
}

TextBlock render_ascii(const std::string& letters, int size_px, bool bold) {
    constexpr int one_pixel_per_point = 72, alpha = 3;
    vtkNew<vtkTextProperty> style;
    style->SetFontFamilyToArial();
    style->SetFontSize(size_px);
    style->SetBold(bold ? 1 : 0);
    vtkNew<vtkImageData> image;
    int size[2] = {0, 0};
    vtkFreeTypeTools::GetInstance()->RenderString(style, vtkStdString(letters), one_pixel_per_point, image, size);
    TextBlock block{size[0], size[1], {}};
    block.coverage.reserve(static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
    int extent[6];
    image->GetExtent(extent);
    for (int y = extent[2] + block.height - 1; y >= extent[2]; --y) {
        for (int x = extent[0]; x < extent[0] + block.width; ++x) {
            block.coverage.push_back(static_cast<const std::uint8_t*>(image->GetScalarPointer(x, y, 0))[alpha]);
        }
    }
    return block;
}

/// `right` beside `left`, tops aligned.
TextBlock beside(const TextBlock& left, const TextBlock& right) {
    TextBlock both{left.width + right.width, std::max(left.height, right.height), {}};
    both.coverage.resize(static_cast<std::size_t>(both.width) * static_cast<std::size_t>(both.height));
    const auto copy = [&](const TextBlock& from, int column) {
        for (int y = 0; y < from.height; ++y) {
            std::copy_n(from.coverage.begin() + y * from.width, from.width,
                        both.coverage.begin() + y * both.width + column);
        }
    };
    copy(left, 0);
    copy(right, left.width);
    return both;
}

}  // namespace

TextBlock render_text(const std::string& text, int size_px, bool bold) {
    assert(size_px >= 8);
    TextBlock block;
    for (const Run& run : runs_of(text)) {
        block = beside(block, render_ascii(run.letters, run.raised ? size_px * 2 / 3 : size_px, bold));
    }
    return block;
}

}  // namespace waterlight
