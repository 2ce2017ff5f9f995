// The water surface at one time: what the wave models give and the light takes.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "sim/boundary.hpp"
#include "sim/field.hpp"
#include "sim/grid.hpp"

namespace waterlight {

struct Surface {
    Grid grid;
    Boundary boundary;
    double time_s = 0;
    /// Mean slope. The periodic continuation climbs by it: eta(x + width, y) = eta(x, y) + tilt.x * width.
    /// elevation and slopes below already contain it.
    glm::dvec2 tilt{0, 0};

    Field<float> elevation;  ///< m, above still water
    Field<float> slope_x;    ///< d elevation / dx
    Field<float> slope_y;    ///< d elevation / dy

    /// Where the model has them: velocity of the water at the surface (m/s), depth of water (m).
    std::optional<Field<float>> velocity_x;
    std::optional<Field<float>> velocity_y;
    std::optional<Field<float>> depth;

    Surface() = default;
    /// A flat surface.
    Surface(const Grid& g, Boundary b)
        : grid(g), boundary(b), elevation(g.nx, g.ny), slope_x(g.nx, g.ny), slope_y(g.nx, g.ny) {}
};

}  // namespace waterlight
