// OpenEXR: a field in full precision, for image tools.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <string>

#include "sim/field.hpp"

namespace waterlight {

/// What the header of the file says besides the values.
struct ExrDescription {
    std::string quantity;  ///< "irradiance"
    std::string unit;      ///< "W/m2"
    double time_s = 0;
    glm::dvec2 pitch_m{1, 1};  ///< size of a pixel
};

/// One 32-bit float channel "Y", the row of largest y on top, uncompressed, whole or not at all. Attributes of the
/// header: quantity, unit (strings), time_s (double), pitch_m (two doubles), and pixelAspectRatio = pitch x / pitch y.
/// Throws WorldError.
void write_exr(const std::filesystem::path& path, const Field<float>& field, const ExrDescription& description);

}  // namespace waterlight
