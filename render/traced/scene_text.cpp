#include "render/traced/scene_text.hpp"

#include <algorithm>

#include "caustics/phase.hpp"

namespace waterlight {

SceneData::SceneData(const Scene& scene, const Look& look, const Camera& camera)
    : variant_(variant_of(scene, look, camera.position_m)), view_(view_parameters(camera)) {
    fill_levels(*scene.surface, scene.ground_m, surface_);
    fill_maps(scene, look.overlay, maps_);
    const PhaseTable phase(scene.optics.phase);
    medium_.assign(phase.values().begin(), phase.values().end());
    const auto volume = static_cast<int>(medium_.size());
    if (scene.volume != nullptr) {
        const auto values = scene.volume->scalar_irradiance.values();
        medium_.insert(medium_.end(), values.begin(), values.end());
    }
    if (scene.ground_m != nullptr) ground_ = padded_ground(*scene.surface, *scene.ground_m);
    const double depth = variant_.in_water ? std::max(0.0, -camera.position_m.z) : 0;
    scene_ = scene_parameters(scene, look, surface_, maps_, volume, depth);
}

f32::SceneText SceneData::text() const {
    f32::SceneText t;
    t.in_water = variant_.in_water;
    t.wall_x = variant_.wall_x;
    t.wall_y = variant_.wall_y;
    t.wraps_x = variant_.wraps_x;
    t.wraps_y = variant_.wraps_y;
    t.uneven = variant_.uneven;
    t.map_colours = static_cast<int>(variant_.map_colours);
    t.wall_maps = variant_.wall_maps;
    t.scatter = static_cast<int>(variant_.scatter);
    t.floor_pattern = static_cast<int>(variant_.floor_pattern);
    t.wall_pattern = static_cast<int>(variant_.wall_pattern);
    t.deck_pattern = static_cast<int>(variant_.deck_pattern);
    t.overlay = static_cast<int>(variant_.overlay);
    t.uniform_sky = variant_.uniform_sky;
    t.outside = variant_.outside;
    t.p = view_;
    t.s = scene_;
    t.surface_cells = surface_.cells.data();
    t.light = maps_.values.data();
    t.medium = medium_.data();
    t.ground = ground_.data();
    return t;
}

}  // namespace waterlight
