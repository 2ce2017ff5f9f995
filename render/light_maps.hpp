// The irradiance of floor and walls as the passes read it: with a margin of one pixel, the floor's ever coarser.
#pragma once

#include <array>
#include <vector>

#include "render/look.hpp"
#include "render/scene.hpp"

namespace waterlight {

struct LightMaps {
    static constexpr int most_levels = 6;
    std::vector<float> values;  ///< W/m2
    int levels = 0;             ///< of the floor; colours of a level one after another
    std::array<int, most_levels> floor_offset{};
    std::array<int, 4> wall_offset{};
};

/// Of the scene's maps; with the overlay of the error, of that in place of the floor's.
void fill_maps(const Scene& scene, Overlay overlay, LightMaps& maps);

}  // namespace waterlight
