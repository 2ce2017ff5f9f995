// What a picture asks of its settings.
#include <fmt/format.h>

#include <cmath>

#include "render/scene_block.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

void check_finish(const Finish& finish, const char* what) {
    for (int c = 0; c < 3; ++c)
        if (!(finish.albedo[c] >= 0 && finish.albedo[c] <= 1))
            throw InputError(fmt::format("look: the albedo of the {} is {}; in [0, 1]", what, finish.albedo[c]));
    if (!(finish.tile_m > 0))
        throw InputError(fmt::format("look: a tile of the {} is {} m; above 0", what, finish.tile_m));
}

void check_look(const Look& look) {
    check_finish(look.floor, "floor");
    check_finish(look.walls, "walls");
    check_finish(look.deck, "deck");
    if (!(look.freeboard_m >= 0))
        throw InputError(fmt::format("look: freeboard is {} m; at least 0", look.freeboard_m));
    if (look.exposure_w_m2_sr && !(*look.exposure_w_m2_sr > 0))
        throw InputError(fmt::format("look: exposure is {} W/(m2 sr); above 0", *look.exposure_w_m2_sr));
    if (look.sky.irradiance_w_m2 && !(*look.sky.irradiance_w_m2 >= 0))
        throw InputError(fmt::format("look: the sky's irradiance is {} W/m2; at least 0", *look.sky.irradiance_w_m2));
    if (look.samples != 1 && look.samples != 2 && look.samples != 4 && look.samples != 8)
        throw InputError(fmt::format("look: {} samples of a pixel; 1, 2, 4 or 8", look.samples));
    for (int c = 0; c < 3; ++c)
        if (!(look.colour_per_m[c] >= 0))
            throw InputError(fmt::format("look: absorption of a colour is {} 1/m; at least 0", look.colour_per_m[c]));
    if (look.overlay != Overlay::none && !(look.range.high > look.range.low))
        throw InputError(
            fmt::format("look: the overlay's range is {} to {}; it must rise", look.range.low, look.range.high));
}

void check_camera(const Camera& c) {
    if (c.size.x < 1 || c.size.y < 1)
        throw InputError(fmt::format("camera: size is {} x {} pixels; at least 1 x 1", c.size.x, c.size.y));
    if (!(c.fov_deg > 0 && c.fov_deg < 180)) throw InputError("camera: fov_deg must be in (0, 180)");
    for (int k = 0; k < 3; ++k)
        if (!std::isfinite(c.position_m[k]) || !std::isfinite(c.target_m[k]))
            throw InputError("camera: position_m and target_m must be finite");
    if (c.position_m == c.target_m) throw InputError("camera: it must not stand on its target");
}

void check_map(const Scene& scene, const Field<float>* map, const char* what) {
    const FloorPlan& plan = scene.floor_plan;
    if (map != nullptr && (map->nx() != plan.width || map->ny() != plan.height))
        throw InputError(fmt::format("scene: the {} has {} x {} pixels; its plan has {} x {}", what, map->nx(),
                                     map->ny(), plan.width, plan.height));
}

}  // namespace

void validate(const Scene& scene, const Look& look, const Camera& camera) {
    check_look(look);
    check_camera(camera);
    if (!(scene.depth_m > 0)) throw InputError(fmt::format("scene: depth is {} m; above 0", scene.depth_m));
    if (!(scene.optics.refractive_index >= 1))
        throw InputError(fmt::format("scene: the index is {}; at least 1", scene.optics.refractive_index));
    check_map(scene, scene.floor, "floor map");
    for (const Field<float>* map : scene.floor_rgb) check_map(scene, map, "floor map of a colour");
    if (look.overlay == Overlay::error) {
        if (scene.error == nullptr) throw InputError("look: the overlay of the error, and the scene has none");
        check_map(scene, scene.error, "error");
    }
    const Grid& g = scene.surface->grid;
    if (scene.ground_m != nullptr && (scene.ground_m->nx() != g.nx || scene.ground_m->ny() != g.ny))
        throw InputError(fmt::format("scene: the ground has {} x {} cells; the surface has {} x {}",
                                     scene.ground_m->nx(), scene.ground_m->ny(), g.nx, g.ny));
}

}  // namespace waterlight
