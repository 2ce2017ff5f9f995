// What of a picture's shaders is compiled in: the specialisation constants of render/shaders/scene.glsl, in their
// order.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "render/look.hpp"
#include "render/scene.hpp"

namespace waterlight {

struct Variant {
    bool in_water = false;  ///< the camera
    bool wall_x = false, wall_y = false, wraps_x = false, wraps_y = false;
    bool uneven = false;  ///< ground
    std::uint32_t map_colours = 0;
    bool wall_maps = false;
    std::uint32_t scatter = 0;
    std::uint32_t floor_pattern = 0, wall_pattern = 0, deck_pattern = 0;
    std::uint32_t overlay = 0;
    bool uniform_sky = false;
    bool coarse = false;
    bool outside = false;    ///< a camera in the water, but beside the pool
    std::uint32_t kind = 0;  ///< of what a pass draws

    std::vector<std::uint32_t> constants() const;
};

/// Of a scene seen from `eye`; `coarse` and `kind` are each draw's own.
Variant variant_of(const Scene& scene, const Look& look, glm::dvec3 eye_m);

/// Whether the camera's place is below the surface there. Beyond walls the water is taken for still.
bool below_surface(const Surface& surface, glm::dvec3 eye_m);

/// Whether it is beyond a wall of the domain.
bool beyond_walls(const Surface& surface, glm::dvec3 eye_m);

}  // namespace waterlight
