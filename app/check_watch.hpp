// Follows a run and keeps the values that its checks judge.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/field_check.hpp"
#include "app/report.hpp"

namespace waterlight {

class CheckWatch {
  public:
    explicit CheckWatch(const Scenario& scenario);

    /// Whether a check judges this frame.
    bool wants(double time_s) const;
    /// Of every row of probes.csv, frames included.
    void add_row(double time_s, const std::map<std::string, ProbeRecord>& probes);
    /// Of the frames that are wanted. Throws WorldError where a reference can no longer be used.
    void add_frame(double time_s, const std::map<std::string, double>& quantities, const FrameFields& fields);
    /// Throws InputError where a file that a check refers to does not fit the run, of which this is any frame.
    void require_references(const FrameFields& fields) const;

    /// Gives what was kept so far to the archive, or takes it from there.
    void exchange_state(StateArchive& state);

    /// One for each check, in their order; NaN where the run has none.
    std::vector<double> values() const;

  private:
    /// What one check has seen.
    struct Seen {
        std::vector<double> times_s, values;
    };

    bool is_in(const Check& check, double time_s) const;
    double value_of(const Check& check, const Seen& seen) const;

    const Scenario& scenario_;
    std::vector<Seen> seen_;  ///< one for each check
};

/// Times (s) at which checks judge a frame of their own, ascending.
std::vector<double> checked_times(const Scenario& scenario);

}  // namespace waterlight
