// Three fields as the red, green and blue of a picture.
#pragma once

#include <array>
#include <filesystem>

#include "sim/field.hpp"

namespace waterlight {

/// The fields of red, green and blue light, of one size, and for each the value that is full.
struct ColourFields {
    std::array<const Field<float>*, 3> field{};
    std::array<double, 3> full{1, 1, 1};  ///< > 0
};

/// A pixel a value, the row of largest y on top, encoded as sRGB (IEC 61966-2-1), values above full cut. Whole or not
/// at all. Throws WorldError.
void write_colour_picture(const std::filesystem::path& path, const ColourFields& fields);

}  // namespace waterlight
