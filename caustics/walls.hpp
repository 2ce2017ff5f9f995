// Light on the walls of a pool: each triangle of the refracted surface is cut into what reaches the floor and what
// meets each wall first, and that shared exactly among the wall's pixels.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <string_view>
#include <vector>

#include "caustics/light_ledger.hpp"
#include "sim/surface.hpp"

namespace waterlight {

/// The four walls in the order of their maps: x low, x high, y low, y high.
inline constexpr std::array<std::string_view, 4> wall_names{"west", "east", "south", "north"};

struct WallSettings {
    double pixel_m = 0.01;  ///< size of a pixel at most, > 0
    double above_m = 0.1;   ///< how far the maps reach above still water, >= 0
    double depth_m = 1;     ///< floor at z = -depth, > 0
    Sun sun;
    WaterOptics optics;
};

/// How a wall is cut into pixels: columns along x or y from the domain's low side, rows from the floor up. Whole pixels
/// fill its length and its depth; more rows reach above still water.
struct WallPlan {
    int columns = 1;
    int rows = 1;
    glm::dvec2 pitch_m{1, 1};  ///< along the wall, and up
};

/// Of wall 0 to 3 of this domain.
WallPlan wall_plan(const WallSettings& settings, const Grid& grid, int wall);

struct WallMaps {
    /// W/m2 of wall, averaged over each pixel; empty where the side is not a wall.
    std::array<Field<float>, 4> irradiance;
    std::array<double, 4> power_w{};  ///< on each wall
    /// Of all the light that enters. Beyond sides that are no walls, and above the maps, it is outside. A periodic side
    /// is passed by as much as comes in over the other: its light stays inside.
    LightLedger ledger;
};

/// Lights the walls; needs no more than the surface. Triangles of the surface have their corners on its cells' corners,
/// rays of light are straight from there; what walls reflect is not followed. Deterministic. `maps` is reused where its
/// sizes fit. Throws InputError where a setting is out of its range or no side is a wall.
void light_walls(const WallSettings& settings, const Surface& surface, WallMaps& maps);

}  // namespace waterlight
