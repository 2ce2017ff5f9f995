// Follows a run frame by frame and keeps what its report needs.
#pragma once

#include <functional>
#include <vector>

#include "app/report.hpp"
#include "scenarios/scenario.hpp"

namespace waterlight {

class Recorder {
  public:
    explicit Recorder(const Scenario& scenario);

    void add_frame(double time_s);
    /// Of some frames, the first among them: what is conserved is watched.
    void add_waves(double time_s, const WaveDiagnostics& diagnostics);
    void add_floor(const FloorMap& map, const LightLedger& ledger, const MethodRecord& method);
    /// Of the last map.
    void add_statistics(const FloorMap& map);
    /// Reads the probes; returns the columns of probes.csv. `light` is asked of every probe, and heard where it has a
    /// depth or the scenario a floor.
    std::vector<double> add_probes(const Surface& surface, const std::function<ProbeLight(const Probe&)>& light);

    RunRecord& record() { return record_; }

    /// Gives what was kept so far to the archive, or takes it from there.
    void exchange_state(StateArchive& state);

  private:
    const Scenario& scenario_;
    RunRecord record_;
    double conserved_from_s_;  ///< energy neither comes in nor goes out after this; infinite where it always may
    double conserved_j_;       ///< the energy then; NaN before
    bool watched_ = false;     ///< add_waves() was called
};

}  // namespace waterlight
