// The part of a run that lights the walls.
#pragma once

#include "caustics/walls.hpp"
#include "scenarios/scenario.hpp"
#include "sim/state_archive.hpp"

namespace waterlight {

/// The walls over the run.
struct WallRecord {
    LightLedger last_ledger, sum;
    double closure = 0;                    ///< largest of a frame
    std::array<double, 4> last_power_w{};  ///< on each wall
};

/// Computes on the CPU. The scenario has walls and outlives the stage.
class WallStage {
  public:
    explicit WallStage(const Scenario& scenario) : scenario_(scenario) {}

    /// In colour, the sum over the wavelengths. Throws InputError where a setting does not go with the surface.
    void compute(const Surface& surface);
    /// Takes the frame just computed into the record.
    void add_frame();
    const WallRecord& record() const { return record_; }
    /// Gives the record so far to the archive, or takes it from there.
    void exchange_state(StateArchive& state) { state.value(record_); }
    const WallMaps& maps() const { return maps_; }

  private:
    const Scenario& scenario_;
    WallMaps maps_, band_;
    WallRecord record_;
};

}  // namespace waterlight
