// The part of a run that says how wrong the run is: [accuracy] estimate = true.
#pragma once

#include <limits>
#include <optional>

#include "app/floor_estimate.hpp"
#include "app/wave_estimate.hpp"

namespace waterlight {

/// Relative RMSE of the last frame; NaN where there is no estimate.
struct AccuracyRecord {
    double floor_rmse = std::numeric_limits<double>::quiet_NaN();
    double waves_rmse = std::numeric_limits<double>::quiet_NaN();
};

/// The floor map's error is estimated for the method two-pass (the truth has its own estimate), the surface's for every
/// model but prescribed.
class AccuracyStage {
  public:
    /// `model` outlives the stage.
    AccuracyStage(const Scenario& scenario, const BuiltModel& model, const BackendDecision& backend);

    /// With the model itself.
    void advance(double seconds);
    /// `map` is null without a floor.
    void compute(const Surface& surface, const FloorMap* map);
    /// Gives what goes on from frame to frame to the archive, or takes it from there.
    void exchange_state(StateArchive& state);

    const Field<float>* floor_error() const { return floor_ ? &floor_->error() : nullptr; }
    const Field<float>* waves_error() const { return waves_ ? &waves_->error() : nullptr; }
    AccuracyRecord record() const;

  private:
    const SurfaceFormula* formula_;
    std::optional<FloorEstimate> floor_;
    std::optional<WaveEstimate> waves_;
};

}  // namespace waterlight
