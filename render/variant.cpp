#include "render/variant.hpp"

#include <cmath>

#include "caustics/kernels/surface_lookup.hpp"

namespace waterlight {

namespace {

#include "render/shaders/variant_words.glsl"

std::uint32_t pattern_number(Finish::Pattern pattern) { return static_cast<std::uint32_t>(pattern); }

std::uint32_t scatter_number(const Scene& scene, bool in_water) {
    if (!(scene.optics.scattering_per_m > 0)) return SCATTER_NONE;
    if (in_water && scene.beams != nullptr) return SCATTER_NONE;
    return scene.volume != nullptr ? SCATTER_VOLUME : SCATTER_FLAT;
}

std::uint32_t overlay_number(Overlay overlay) {
    switch (overlay) {
        case Overlay::elevation:
            return OVERLAY_ELEVATION;
        case Overlay::irradiance:
            return OVERLAY_FLOOR;
        case Overlay::error:
            return OVERLAY_ERROR;
        case Overlay::none:
            break;
    }
    return OVERLAY_NONE;
}

f64::AxisPlace place(double from_first_centre, int n, Side side) {
    const double whole = std::floor(from_first_centre);
    return f64::place_on_axis(static_cast<int>(whole), from_first_centre - whole, n, side_number(side), 0.5);
}

}  // namespace

std::vector<std::uint32_t> Variant::constants() const {
    return {in_water,      wall_x,       wall_y,       wraps_x, wraps_y,     uneven, map_colours, wall_maps, scatter,
            floor_pattern, wall_pattern, deck_pattern, overlay, uniform_sky, coarse, outside,     kind};
}

bool beyond_walls(const Surface& surface, glm::dvec3 eye) {
    const Grid& g = surface.grid;
    const bool beyond_x = eye.x < g.x0_m || eye.x > g.x0_m + g.width_m();
    const bool beyond_y = eye.y < g.y0_m || eye.y > g.y0_m + g.height_m();
    return (surface.boundary.x == Side::wall && beyond_x) || (surface.boundary.y == Side::wall && beyond_y);
}

bool below_surface(const Surface& surface, glm::dvec3 eye) {
    if (beyond_walls(surface, eye)) return eye.z < 0;
    const Grid& g = surface.grid;
    const f64::AxisPlace x = place((eye.x - g.x_m(0)) / g.dx_m, g.nx, surface.boundary.x);
    const f64::AxisPlace y = place((eye.y - g.y_m(0)) / g.dy_m, g.ny, surface.boundary.y);
    const Field<float>& e = surface.elevation;
    const double height =
        f64::bilinear(e(x.low, y.low), e(x.high, y.low), e(x.low, y.high), e(x.high, y.high), x.weight, y.weight);
    const double climb =
        surface.tilt.x * g.width_m() * wraps_between(x) + surface.tilt.y * g.height_m() * wraps_between(y);
    return eye.z < x.water * y.water * height + climb;
}

Variant variant_of(const Scene& scene, const Look& look, glm::dvec3 eye) {
    const Boundary& sides = scene.surface->boundary;
    Variant v;
    v.in_water = below_surface(*scene.surface, eye);
    v.outside = v.in_water && beyond_walls(*scene.surface, eye);
    v.wall_x = sides.x == Side::wall;
    v.wall_y = sides.y == Side::wall;
    v.wraps_x = sides.x == Side::periodic;
    v.wraps_y = sides.y == Side::periodic;
    v.uneven = scene.ground_m != nullptr;
    const bool mapped = look.overlay == Overlay::error ? scene.error != nullptr : scene.floor != nullptr;
    v.map_colours = mapped ? 1 : 0;
    if (scene.floor_rgb[0] != nullptr && look.overlay != Overlay::error) v.map_colours = 3;
    v.wall_maps = scene.walls != nullptr;
    v.scatter = scatter_number(scene, v.in_water);
    v.floor_pattern = pattern_number(look.floor.pattern);
    v.wall_pattern = pattern_number(look.walls.pattern);
    v.deck_pattern = pattern_number(look.deck.pattern);
    v.overlay = overlay_number(look.overlay);
    v.uniform_sky = look.sky.type == Sky::Type::uniform;
    return v;
}

}  // namespace waterlight
