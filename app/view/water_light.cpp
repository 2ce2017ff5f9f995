#include "app/view/water_light.hpp"

#include <algorithm>

#include "app/exact_surface.hpp"
#include "app/readings.hpp"
#include "app/shallow_watch.hpp"
#include "app/view/copies.hpp"
#include "app/view/stopwatch.hpp"
#include "scenarios/build_shallow.hpp"
#include "scenarios/resolve.hpp"
#include "scenarios/resolve_light.hpp"

namespace waterlight {

namespace {

std::shared_ptr<const Field<float>> ground_of(const Scenario& scenario, const BuiltModel& waves) {
    const Grid grid = grid_of(scenario);
    if (waves.shallow) return std::make_shared<const Field<float>>(bed_of(*waves.shallow, grid));
    if (!scenario.domain.bathymetry && scenario.domain.ground.empty()) return nullptr;
    const Field<double> stated = stated_ground(scenario);
    auto ground = std::make_shared<Field<float>>(grid.nx, grid.ny);
    std::copy_n(stated.data(), stated.size(), ground->data());
    return ground;
}

/// Cells of fields for a picture from above: half as many as the beams' grid each way, as far as a picture shows them.
glm::ivec3 cells_for_pictures(glm::ivec2 grid) {
    constexpr int most = 128, layers = 32;
    return {std::clamp(grid.x / 2, 1, most), std::clamp(grid.y / 2, 1, most), layers};
}

void show_bands(std::span<const BandMap> maps, std::vector<BandIrradiance>& bands) {
    bands.resize(maps.size());
    for (std::size_t n = 0; n < maps.size(); ++n) {
        bands[n].band = maps[n].band;
        copy(maps[n].map.irradiance, bands[n].irradiance);
    }
}

}  // namespace

WaterLight::WaterLight(std::shared_ptr<const Scenario> scenario, const BuiltModel& waves,
                       const BackendDecision& backend)
    : scenario_(std::move(scenario)),
      lit_(*scenario_),
      formula_(waves.prescribed ? waves.prescribed->formula() : nullptr),
      ground_m_(ground_of(lit_, waves)) {
    if (lit_.floor) floor_ = make_floor_stage(lit_, waves, backend);
    if (lit_.floor && lit_.accuracy.estimate && lit_.floor->method != FloorMethod::truth)
        estimate_.emplace(floor_settings(lit_));
    lit_.camera.reset();
    if (lit_.beams) {
        lit_.beams->reflected.reset();
        beams_.emplace(lit_, waves, make_beam_renderer(backend));
    }
    if (lit_.walls) walls_.emplace(lit_);
}

void WaterLight::show(const Surface& surface, std::int64_t step, Snapshot& to) {
    const Instant now{surface.time_s, step};
    to.ground_m = ground_m_;
    to.has = {};
    to.costs.floor_ms = to.costs.beams_ms = to.costs.walls_ms = 0;
    to.floor_ledger = to.beams_ledger = to.walls_ledger = {};
    if (floor_ && is_on(LightPart::floor)) show_floor(surface, now, to);
    if (beams_ && is_on(LightPart::beams)) show_beams(surface, now, to);
    if (walls_ && is_on(LightPart::walls)) show_walls(surface, now, to);
}

void WaterLight::show_floor(const Surface& surface, const Instant& now, Snapshot& to) {
    const Stopwatch watch(to.costs.floor_ms);
    floor_->compute(surface, to.floor);
    require_finite("irradiance on the floor", to.floor.irradiance, now);
    to.floor_plan = floor_settings(lit_).plan;
    to.floor_ledger = floor_->ledger(to.floor);
    require_finite("the floor map", to.floor_ledger, now);
    show_bands(floor_->bands(), to.bands);
    to.has.floor = true;
}

/// A picture where the view is from the water, fields where it is from the air, what the scenario states where it is
/// from nowhere.
void WaterLight::aim_beams() {
    BeamsSection& beams = *lit_.beams;
    beams.volume_cells = scenario_->beams->volume_cells;
    lit_.camera.reset();
    if (!view_) return;
    const glm::dvec3 place = view_->camera.position_m;
    if (place.z >= 0) {
        if (!beams.volume_cells) beams.volume_cells = cells_for_pictures(beams.grid);
        return;
    }
    beams.volume_cells.reset();
    if (const BeamGround* ground = beams_->ground(); ground && place.z <= ground->height_m(glm::dvec2(place))) return;
    lit_.camera = scenario_->camera.value_or(CameraSection{});
    lit_.camera->camera = view_->camera;
    lit_.camera->samples = view_->samples;
    lit_.camera->reduction = view_->reduction;
}

void WaterLight::show_beams(const Surface& surface, const Instant& now, Snapshot& to) {
    const Stopwatch watch(to.costs.beams_ms);
    aim_beams();
    beams_->compute(surface);
    to.beams_ledger = beams_->frame_ledger();
    require_finite("the beams", to.beams_ledger, now);
    if (const BeamVolume* volume = beams_->volume()) {
        require_finite("downward irradiance in the water", volume->plane_irradiance, now);
        require_finite("scalar irradiance in the water", volume->scalar_irradiance, now);
        copy(*volume, to.volume);
        to.has.volume = true;
    }
    if (const BeamImage* picture = beams_->image()) {
        require_finite("scattered light", picture->radiance, now);
        copy(*picture, to.beams);
        to.beams_camera = lit_.camera->camera;
        to.has.beams = true;
    }
}

void WaterLight::show_walls(const Surface& surface, const Instant& now, Snapshot& to) {
    const Stopwatch watch(to.costs.walls_ms);
    walls_->compute(surface);
    for (const Field<float>& map : walls_->maps().irradiance) require_finite("irradiance on a wall", map, now);
    copy(walls_->maps(), to.walls);
    to.wall_settings = wall_settings(lit_);
    to.walls_ledger = walls_->maps().ledger;
    require_finite("the walls", to.walls_ledger, now);
    to.has.walls = true;
}

void WaterLight::estimate(const Surface& surface, const FloorMap& map) {
    if (!estimate_ || !is_on(LightPart::floor)) return;
    estimate_->compute(exact_surface(surface, formula_), map.irradiance);
    is_estimated_ = true;
}

void WaterLight::show_estimate(Snapshot& to) const {
    if (to.has.floor && floor_) to.estimates.floor_rmse = floor_->record(to.floor).error_estimate;
    if (!estimate_ || !is_estimated_ || !to.has.floor) return;
    to.estimates.floor_rmse = estimate_->rmse();
    copy(estimate_->error(), to.floor_error);
    to.has.floor_error = true;
}

}  // namespace waterlight
