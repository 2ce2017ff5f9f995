// The water that a camera looks into.
#pragma once

#include <glm/vec3.hpp>

#include "caustics/beams.hpp"
#include "caustics/kernels/beams.hpp"

namespace waterlight {

/// The water around the camera, relative to it: between walls, the highest crest and the floor.
struct WaterBox {
    glm::vec3 low{-1e9F, -1e9F, 0}, high{1e9F, 1e9F, 0};
    WaterBox(const Beams& b, glm::dvec3 eye) {
        const Grid& g = b.domain;
        if (b.boundary.x == Side::wall) {
            low.x = static_cast<float>(g.x0_m - eye.x);
            high.x = static_cast<float>(g.x0_m + g.width_m() - eye.x);
        }
        if (b.boundary.y == Side::wall) {
            low.y = static_cast<float>(g.y0_m - eye.y);
            high.y = static_cast<float>(g.y0_m + g.height_m() - eye.y);
        }
        low.z = static_cast<float>(eye.z - b.highest_m);
        high.z = static_cast<float>(eye.z + b.depth_m);
    }
    f32::WaterSpan span(glm::vec3 r) const { return f32::water_span(r, low, high); }
};

}  // namespace waterlight
