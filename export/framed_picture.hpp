// A picture in true colours with the legend of what it shows.
#pragma once

#include "export/legend.hpp"

namespace waterlight {

/// `settings` of its legend: map, range, quantity, unit, time.
ColourImage framed_picture(const ColourImage& picture, const PictureSettings& settings, Clipped clipped);

}  // namespace waterlight
