// Follows a run frame by frame and keeps what its report needs.
#pragma once

#include <vector>

#include "app/report.hpp"
#include "scenarios/scenario.hpp"

namespace waterlight {

class Recorder {
  public:
    explicit Recorder(const Scenario& scenario);

    void add_waves(double time_s, const WaveDiagnostics& diagnostics);
    void add_floor(const FloorMap& map, double error_estimate);
    /// Reads the probes; returns the columns of probes.csv.
    std::vector<double> add_probes(const Surface& surface, const FloorMap* map);

    RunRecord& record() { return record_; }

  private:
    const Scenario& scenario_;
    FloorPlan plan_;
    RunRecord record_;
    double conserved_from_s_;  ///< energy neither comes in nor goes out after this; infinite where it always may
    double conserved_j_;       ///< the energy then; NaN before
};

}  // namespace waterlight
