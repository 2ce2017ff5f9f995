// Follows the water of the model shallow-water: what is conserved, how far it comes, how far it is from the exact
// state.
#pragma once

#include "app/report.hpp"
#include "scenarios/scenario.hpp"

namespace waterlight {

/// Heights (m) of the model's ground.
Field<float> bed_of(const ShallowWaterModel& model, const Grid& grid);

class ShallowWatch {
  public:
    /// `surface` is that of the start. The model outlives the watch.
    ShallowWatch(const Scenario& scenario, const ShallowWaterModel& model, const Surface& surface);

    void add_frame(const Surface& surface);
    /// Of some frames, the first among them.
    void add_totals();
    /// After the last frame: the record, and of each probe when the water arrived.
    void finish(const Surface& surface, RunRecord& run);

    /// Gives the record so far to the archive, or takes it from there.
    void exchange_state(StateArchive& state);

    /// The ground (m above level 0).
    const Field<float>& bed_m() const { return bed_m_; }
    const ShallowRecords& records() const { return *model_.records(); }
    std::vector<RunupLine> lines() const;

  private:
    double inundated_m2() const;

    const Scenario& scenario_;
    const ShallowWaterModel& model_;
    Grid grid_;
    Field<float> bed_m_;
    Field<float> depth_at_start_m_;
    ShallowRecord record_;
    bool watched_ = false;  ///< add_totals() was called
};

}  // namespace waterlight
