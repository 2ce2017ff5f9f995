// The water of a session: a wave model, and the models beside it that tell its error.
#pragma once

#include <optional>
#include <span>

#include "app/floor_stage.hpp"
#include "app/wave_estimate.hpp"
#include "scenarios/build.hpp"

namespace waterlight {

class MovingWater {
  public:
    /// At time 0. Throws as build_model().
    MovingWater(const Scenario& scenario, const BackendDecision& backend);

    /// The models move together.
    void advance(double seconds);
    /// Throw InputError as WaveModel's; then nothing has changed.
    void disturb(std::span<const Disturbance> disturbances);
    void set_rain(std::span<const Rain> rain);
    /// Goes on from where another of the same kind is. Throws WorldError where that is of another kind; this is of no
    /// use then.
    void take_state(MovingWater& from);

    const BuiltModel& built() const { return built_; }
    WaveModel& model() { return *built_.model; }
    /// Null where the scenario asks for none, or the surface is prescribed.
    WaveEstimate* estimate() { return estimate_ ? &*estimate_ : nullptr; }

  private:
    BuiltModel built_;
    std::optional<WaveEstimate> estimate_;
};

}  // namespace waterlight
