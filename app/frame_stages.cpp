#include "app/frame_stages.hpp"

#include "app/readings.hpp"
#include "app/timed.hpp"

namespace waterlight {

FrameStages::FrameStages(const Scenario& scenario, const DeviceWish& wish)
    : scenario_(scenario),
      backend_(choose_backend(wish, scenario)),
      waves_(scenario.origin.in_place("waves", [&] { return build_model(scenario, backend_.context); })),
      floor_(scenario.floor ? scenario.origin.in_place("caustics.floor",
                                                       [&] { return make_floor_stage(scenario, waves_, backend_); })
                            : nullptr) {
    if (scenario.beams)
        scenario.origin.in_place("caustics.beams",
                                 [&] { beams_.emplace(scenario, waves_, make_beam_renderer(backend_)); });
    if (scenario.walls) walls_.emplace(scenario);
    if (scenario.accuracy.estimate) accuracy_.emplace(scenario, waves_, backend_);
    if (scenario.output.image) picture_.emplace(scenario, waves_, backend_, wish);
}

void FrameStages::advance(double seconds, StageTimes& wall) {
    timed(wall.waves, [&] { waves_.model->advance(seconds); });
    if (accuracy_) timed(wall.accuracy, [&] { accuracy_->advance(seconds); });
}

void FrameStages::look(StageTimes& wall) {
    timed(wall.waves, [&] { surface_ = &waves_.model->surface(); });
    timed(wall.diagnostics, [&] { require_finite(*surface_, waves_.model->steps()); });
}

void FrameStages::compute(StageTimes& wall) {
    look(wall);
    const Instant now{surface_->time_s, waves_.model->steps()};
    if (floor_) compute_floor(now, wall);
    if (beams_) compute_beams(now, wall);
    if (walls_) compute_walls(now, wall);
    if (accuracy_) compute_accuracy(now, wall);
    if (picture_) timed(wall.render, [&] { picture_->draw(view()); });
}

void FrameStages::compute_floor(const Instant& now, StageTimes& wall) {
    timed(wall.floor, [&] { floor_->compute(*surface_, map_); });
    timed(wall.diagnostics, [&] {
        require_finite("irradiance on the floor", map_.irradiance, now);
        require_finite("the floor map", floor_->ledger(map_), now);
    });
}

void FrameStages::compute_beams(const Instant& now, StageTimes& wall) {
    timed(wall.beams, [&] { beams_->compute(*surface_); });
    timed(wall.diagnostics, [&] {
        if (const BeamVolume* volume = beams_->volume()) {
            require_finite("downward irradiance in the water", volume->plane_irradiance, now);
            require_finite("scalar irradiance in the water", volume->scalar_irradiance, now);
        }
        if (const BeamImage* picture = beams_->image()) require_finite("scattered light", picture->radiance, now);
    });
}

void FrameStages::compute_walls(const Instant& now, StageTimes& wall) {
    timed(wall.walls, [&] { walls_->compute(*surface_); });
    timed(wall.diagnostics, [&] {
        for (const Field<float>& map : walls_->maps().irradiance) require_finite("irradiance on a wall", map, now);
        require_finite("the walls", walls_->maps().ledger, now);
    });
}

void FrameStages::compute_accuracy(const Instant& now, StageTimes& wall) {
    timed(wall.accuracy, [&] { accuracy_->compute(*surface_, floor_ ? &map_ : nullptr); });
    timed(wall.diagnostics, [&] {
        if (const Field<float>* error = accuracy_->floor_error())
            require_finite("estimated error of the irradiance on the floor", *error, now);
        if (const Field<float>* error = accuracy_->waves_error())
            require_finite("estimated error of the elevation", *error, now);
    });
}

void FrameStages::compute_for_probes(StageTimes& wall) {
    look(wall);
    bool in_water = false, on_floor = false;
    for (const Probe& probe : scenario_.probes) (probe.depth_m ? in_water : on_floor) = true;
    // The truth of a place needs no map.
    if (on_floor && floor_ && scenario_.floor->method != FloorMethod::truth)
        timed(wall.floor, [&] { floor_->compute(*surface_, map_); });
    if (in_water) timed(wall.beams, [&] { beams_->compute_beams(*surface_); });
}

FrameFields FrameStages::fields() const {
    return {*surface_, floor_ ? &map_ : nullptr, beams_ ? beams_->volume() : nullptr,
            beams_ ? beams_->image() : nullptr};
}

FrameView FrameStages::view() const {
    const FrameFields now = fields();
    FrameView frame{now.surface, now.floor, now.volume, now.picture};
    if (accuracy_) frame.floor_error = accuracy_->floor_error();
    if (accuracy_) frame.waves_error = accuracy_->waves_error();
    if (walls_) frame.walls = &walls_->maps();
    if (floor_) frame.bands = floor_->bands();
    return frame;
}

ProbeLight FrameStages::light_at(const Probe& probe) const {
    ProbeLight light;
    if (probe.depth_m) {
        const PointIrradiance found = beams_->irradiance_at(probe.at_m, *probe.depth_m);
        light = {found.plane_w_m2, found.scalar_w_m2};
    } else if (floor_) {
        light.plane_w_m2 = floor_->irradiance_at(*surface_, map_, probe.at_m);
    }
    return light;
}

void FrameStages::add_frame(double time_s) {
    if (beams_) {
        beams_->add_frame(time_s);
        require_finite("the beams", beams_->ledger(), {time_s, waves_.model->steps()});
    }
    if (walls_) walls_->add_frame();
}

void FrameStages::complete(RunRecord& record) const {
    record.waves.model = waves_.model->name();
    record.waves.steps = waves_.model->steps();
    if (beams_) record.beams = beams_->record();
    if (walls_) record.walls = walls_->record();
    if (accuracy_) {
        record.accuracy = accuracy_->record();
        if (record.floor && record.floor->method.method == FloorMethod::truth)
            record.accuracy->floor_rmse = record.floor->method.error_estimate;
    }
    if (waves_.airy && !waves_.sea.empty()) record.sea = SeaRecord{waves_.airy->sea_coverage(), waves_.sea};
}

std::vector<std::string> FrameStages::validation_messages() const {
    std::vector<std::string> messages;
    if (backend_.context) messages = backend_.context->validation_messages();
    if (messages.empty() && picture_) messages = picture_->validation_messages();
    return messages;
}

void FrameStages::exchange_light(StateArchive& state) {
    if (beams_) beams_->exchange_state(state);
    if (walls_) walls_->exchange_state(state);
}

void FrameStages::exchange_accuracy(StateArchive& state) {
    if (accuracy_) accuracy_->exchange_state(state);
}

}  // namespace waterlight
