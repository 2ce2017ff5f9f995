#include "app/view/snapshot.hpp"

#include <algorithm>

namespace waterlight {

Scene Snapshot::scene() const {
    Scene scene;
    scene.surface = &surface;
    scene.depth_m = scenario->domain.depth_m;
    scene.ground_m = ground_m.get();
    scene.floor_plan = floor_plan;
    if (has.floor) scene.floor = &floor.irradiance;
    if (has.floor && bands.size() == scene.floor_rgb.size()) {
        std::array<const BandIrradiance*, 3> by_length{&bands[0], &bands[1], &bands[2]};
        std::ranges::sort(by_length, std::greater(), [](auto* b) { return b->band.wavelength_nm; });
        std::ranges::transform(by_length, scene.floor_rgb.begin(), [](auto* b) { return &b->irradiance; });
    }
    if (has.walls) scene.walls = &walls;
    scene.wall_settings = wall_settings;
    if (has.volume) scene.volume = &volume;
    if (has.beams) scene.beams = &beams;
    if (has.floor_error) scene.error = &floor_error;
    scene.sun = scenario->light;
    scene.optics = scenario->optics;
    return scene;
}

}  // namespace waterlight
