// The stages that a frame of a run is computed by, in the order of the data flow.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/accuracy_stage.hpp"
#include "app/beam_stage.hpp"
#include "app/field_check.hpp"
#include "app/floor_stage.hpp"
#include "app/outputs.hpp"
#include "app/picture_stage.hpp"
#include "app/report.hpp"
#include "app/wall_stage.hpp"
#include "scenarios/build.hpp"

namespace waterlight {

/// The water, and of the light what the scenario asks for. Every field is searched for values that are not finite: that
/// throws WorldError with the field, the cell, the time and the step.
class FrameStages {
  public:
    /// The scenario outlives the stages. Throws InputError with the place of the section that is refused, gpu::Error
    /// where a device is wanted and there is none.
    FrameStages(const Scenario& scenario, const DeviceWish& wish);

    /// The water moves on. Adds wall time to the stages, as all below do.
    void advance(double seconds, StageTimes& wall);
    /// Takes the surface as it is, without its light.
    void look(StageTimes& wall);
    /// Takes the surface and computes all of a frame. Throws InputError where a setting does not go with the surface.
    void compute(StageTimes& wall);
    /// Takes the surface and computes what probes read between frames.
    void compute_for_probes(StageTimes& wall);

    const BackendDecision& backend() const { return backend_; }
    const BuiltModel& waves() const { return waves_; }
    /// As last taken.
    const Surface& surface() const { return *surface_; }
    /// Null where the scenario draws no map.
    const FloorStage* floor() const { return floor_.get(); }
    const FloorMap& map() const { return map_; }
    const WallStage* walls() const { return walls_ ? &*walls_ : nullptr; }
    const BeamStage* beams() const { return beams_ ? &*beams_ : nullptr; }
    const PictureStage* picture() const { return picture_ ? &*picture_ : nullptr; }

    /// What was computed of this frame, but the picture and the ledgers.
    FrameView view() const;
    FrameFields fields() const;
    /// As a probe reads it: in the water, or on the floor.
    ProbeLight light_at(const Probe& probe) const;

    /// Takes the beams and walls of the frame just computed into their records.
    void add_frame(double time_s);
    /// What the stages know of the run, into a record of it.
    void complete(RunRecord& record) const;
    /// The messages of the Vulkan validation layer.
    std::vector<std::string> validation_messages() const;

    /// Gives the water to the archive, or takes it from there.
    void exchange_water(StateArchive& state) { waves_.model->exchange_state(state); }
    /// The records of the beams and the walls.
    void exchange_light(StateArchive& state);
    /// The state and the record of the estimate of errors.
    void exchange_accuracy(StateArchive& state);

  private:
    void compute_floor(const Instant& now, StageTimes& wall);
    void compute_beams(const Instant& now, StageTimes& wall);
    void compute_walls(const Instant& now, StageTimes& wall);
    void compute_accuracy(const Instant& now, StageTimes& wall);

    const Scenario& scenario_;
    BackendDecision backend_;
    BuiltModel waves_;
    std::unique_ptr<FloorStage> floor_;
    std::optional<BeamStage> beams_;
    std::optional<WallStage> walls_;
    std::optional<AccuracyStage> accuracy_;
    std::optional<PictureStage> picture_;
    const Surface* surface_ = nullptr;
    FloorMap map_;
};

}  // namespace waterlight
