// A field as a picture that explains itself: colours, a colour bar with its unit, the time, a bar of known length.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "export/colour_map.hpp"
#include "export/png.hpp"
#include "export/range.hpp"
#include "sim/field.hpp"

namespace waterlight {

struct PictureSettings {
    ColourMap map = ColourMap::viridis;
    ValueRange range;      ///< of the colour bar; values beyond take its end colours and give it pointed ends
    std::string quantity;  ///< "Irradiance on the floor"; UTF-8 in the range of Latin-1, as is the unit
    std::string unit;      ///< "W/m\u00b2"
    std::optional<double> time_s;
    glm::dvec2 pitch_m{1, 1};  ///< size of a cell, > 0
    bool legend = true;        ///< false: the colours only
    bool length_bar = true;    ///< of the legend; false where a pixel is no length
    Rgb missing{255, 0, 200};  ///< colour of NaN
};

/// x to the right, y up, true to scale up to a domain of 8 : 1. Each cell becomes one or more whole pixels where cells
/// are square; a small field is enlarged to at least 480 pixels on its longer side.
IndexedImage draw_picture(const Field<float>& field, const PictureSettings& settings);

/// draw_picture into a PNG, whole or not at all. Throws WorldError. One thread at a time (see render_text).
void write_picture(const std::filesystem::path& path, const Field<float>& field, const PictureSettings& settings);

}  // namespace waterlight
