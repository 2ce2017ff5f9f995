#include "app/view/moving_water.hpp"

#include <utility>

namespace waterlight {

MovingWater::MovingWater(const Scenario& scenario, const BackendDecision& backend)
    : built_(build_model(scenario, backend.context)) {
    if (scenario.accuracy.estimate && !built_.prescribed) estimate_.emplace(scenario, backend);
}

void MovingWater::advance(double seconds) {
    built_.model->advance(seconds);
    if (estimate_) estimate_->advance(seconds);
}

void MovingWater::disturb(std::span<const Disturbance> disturbances) {
    built_.model->disturb(disturbances);
    if (estimate_) estimate_->disturb(disturbances);
}

void MovingWater::set_rain(std::span<const Rain> rain) {
    built_.model->set_rain(rain);
    if (estimate_) estimate_->set_rain(rain);
}

void MovingWater::take_state(MovingWater& from) {
    StateArchive given;
    const bool with_estimate = estimate_ && from.estimate_;
    from.built_.model->exchange_state(given);
    if (with_estimate) from.estimate_->exchange_state(given);
    std::string bytes;
    for (const std::string& part : given.parts()) bytes += part;
    StateArchive taken(std::move(bytes));
    built_.model->exchange_state(taken);
    if (with_estimate) estimate_->exchange_state(taken);
    taken.require_end();
}

}  // namespace waterlight
