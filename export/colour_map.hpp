// Colour maps whose steps look equal.
#pragma once

#include "export/png.hpp"

namespace waterlight {

/// viridis: dark to bright, for quantities that start at zero. cool_warm: blue, grey, red, for quantities about zero.
/// deep_water: dark blue to white, for pictures of light in water.
enum class ColourMap { viridis, cool_warm, deep_water };

/// Of dry ground beside the colours of water: told apart from every colour of cool_warm and viridis.
inline constexpr Rgb ground_colour{151, 128, 98};

/// The colour at `position` in [0, 1], clamped.
Rgb colour(ColourMap map, double position);

}  // namespace waterlight
