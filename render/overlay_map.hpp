// The colours of overlays, the same in the picture and in its legend.
#pragma once

#include "export/colour_map.hpp"
#include "render/look.hpp"

namespace waterlight {

/// Elevation and errors go both ways from zero.
inline ColourMap overlay_map(Overlay overlay) {
    return overlay == Overlay::irradiance ? ColourMap::viridis : ColourMap::cool_warm;
}

}  // namespace waterlight
