#include "app/accuracy_stage.hpp"

#include "app/exact_surface.hpp"
#include "scenarios/resolve.hpp"

namespace waterlight {

AccuracyStage::AccuracyStage(const Scenario& scenario, const BuiltModel& model, const BackendDecision& backend)
    : formula_(model.prescribed ? model.prescribed->formula() : nullptr) {
    if (scenario.floor && scenario.floor->method != FloorMethod::truth) floor_.emplace(floor_settings(scenario));
    if (!model.prescribed) waves_.emplace(scenario, backend);
}

void AccuracyStage::advance(double seconds) {
    if (waves_) waves_->advance(seconds);
}

void AccuracyStage::compute(const Surface& surface, const FloorMap* map) {
    if (waves_) waves_->compute(surface);
    if (floor_ && map) floor_->compute(exact_surface(surface, formula_), map->irradiance);
}

void AccuracyStage::exchange_state(StateArchive& state) {
    if (floor_) floor_->exchange_state(state);
    if (waves_) waves_->exchange_state(state);
}

AccuracyRecord AccuracyStage::record() const {
    AccuracyRecord record;
    if (floor_) record.floor_rmse = floor_->rmse();
    if (waves_) record.waves_rmse = waves_->rmse();
    return record;
}

}  // namespace waterlight
