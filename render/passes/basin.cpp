#include "render/passes/basin.hpp"

#include "shaders/basin.hpp"
#include "shaders/basin_faces.hpp"

namespace waterlight {

namespace {

#include "render/shaders/variant_words.glsl"

/// Whether the camera is on the side of a wall (0 to 3) that the water is on.
bool faces(const Frame& frame, int wall) {
    const Grid& g = frame.scene.surface->grid;
    const glm::dvec3 eye = frame.eye();
    switch (wall) {
        case 0:
            return frame.variant.wall_x && eye.x > g.x0_m;
        case 1:
            return frame.variant.wall_x && eye.x < g.x0_m + g.width_m();
        case 2:
            return frame.variant.wall_y && eye.y > g.y0_m;
        default:
            return frame.variant.wall_y && eye.y < g.y0_m + g.height_m();
    }
}

bool has_deck(const Frame& frame) {
    return (frame.variant.wall_x || frame.variant.wall_y) && frame.eye().z > frame.look.freeboard_m;
}

bool has_floor(const Frame& frame) { return frame.variant.in_water && !frame.variant.uneven; }

}  // namespace

BasinPass::BasinPass(std::shared_ptr<gpu::Context> context)
    : pass_(std::move(context), surface_settings("basin", shaders::basin_faces, shaders::basin)) {}

bool BasinPass::needed(const Frame& frame) { return has_floor(frame) || frame.variant.wall_x || frame.variant.wall_y; }

void BasinPass::record(const Frame& frame) {
    if (has_floor(frame) && frame.eye().z > -frame.scene.depth_m) draw(frame, KIND_FLOOR, 0, 1);
    for (int wall = 0; wall < 4; ++wall)
        if (faces(frame, wall)) draw(frame, KIND_WALLS, wall, 1);
    if (!has_deck(frame)) return;
    if (frame.variant.wall_x) draw(frame, KIND_DECK, 0, 2);
    if (frame.variant.wall_y) draw(frame, KIND_DECK, 2, 2);
}

void BasinPass::draw(const Frame& frame, std::uint32_t kind, int first, std::uint32_t count) {
    PassParameters p = frame.view;
    const SurfaceLevel& finest = frame.surface.levels.front();
    p.level_offset = finest.offset;
    p.level_nx = finest.nx;
    p.level_ny = finest.ny;
    p.level_scale = finest.scale;
    p.first_copy = first;
    Variant variant = frame.variant;
    variant.kind = kind;
    frame.commands.draw(pass_.bound(frame, variant), frame.radiance, {count, 4}, p);
}

}  // namespace waterlight
