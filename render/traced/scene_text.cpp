#include "render/traced/scene_text.hpp"

#include <algorithm>

#include "caustics/phase.hpp"

namespace waterlight {

namespace {

#include "render/shaders/variant_words.glsl"

}  // namespace

SceneData::SceneData(const Scene& scene, const Look& look, const Camera& camera)
    : variant_(variant_of(scene, look, camera.position_m)), size_(camera.size), view_(view_parameters(camera)) {
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
    // A picture of beams has the light scattered on the way of sight; on further ways it is that of calm water.
    if (variant_.in_water) beams_ = scene.beams;
    if (beams_ != nullptr && scene.optics.scattering_per_m > 0) variant_.scatter = SCATTER_FLAT;
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
    if (beams_ != nullptr) {
        t.beams = beams_->radiance.data();
        t.p.columns = beams_->radiance.nx();
        t.p.rows = beams_->radiance.ny();
        t.p.u1 = static_cast<float>(size_.x);
        t.p.v1 = static_cast<float>(size_.y);
    }
    return t;
}

std::optional<f32::SceneText> SceneData::things_text() const {
    if (things_ == nullptr) return std::nullopt;
    f32::SceneText t = text();
    t.medium = things_->scalar_irradiance.data();
    t.s.volume_nx = things_->cells.x;
    t.s.volume_ny = things_->cells.y;
    t.s.volume_nz = things_->cells.z;
    t.s.volume_offset = 0;
    t.s.volume_depth = static_cast<float>(things_->depth_m);
    return t;
}

}  // namespace waterlight
