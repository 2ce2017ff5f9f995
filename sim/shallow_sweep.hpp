// One stage of the shallow-water scheme, row by row: the loops around sim/kernels/shallow_water.glsl.
#pragma once

#include <vector>

#include "sim/shallow_rows.hpp"
#include "sim/shallow_solver.hpp"

namespace waterlight {

/// Stages for one grid. Fields are handled in bands of rows, one a thread; each row comes out the same whatever the
/// bands.
template <class Real>
class ShallowSweep {
  public:
    /// `periodic_*`: the frame along that axis is what lies on the other side.
    ShallowSweep(int nx, int ny, bool periodic_x, bool periodic_y);

    /// The friction before the step.
    void rub(const ShallowStage<Real>& stage, const ShallowStart<Real>& start, const ShallowFields<Real>& change,
             ShallowFields<Real>& now);

    /// Heun's first stage: change = dt L(now). The depth of now + change stays at or above 0, and what leaves a cell
    /// enters its neighbours. The frames of `start` and `now` are filled.
    void first_stage(const ShallowStage<Real>& stage, const ShallowStart<Real>& start, const ShallowFields<Real>& now,
                     ShallowFields<Real>& change);

    /// The second: now += (change + dt L(now + change)) / 2, then the friction after it. The frame of `change` is
    /// filled too.
    ShallowPeak second_stage(const ShallowStage<Real>& stage, const ShallowStart<Real>& start,
                             const ShallowFields<Real>& change, ShallowFields<Real>& now);

    /// Settles the discharge of films and finds the fastest waves, as the second stage does at its end. `change` is of
    /// no account.
    ShallowPeak look(const ShallowStage<Real>& stage, const ShallowStart<Real>& start,
                     const ShallowFields<Real>& change, ShallowFields<Real>& now);

    /// What it keeps from step to step.
    void exchange_state(StateArchive& state) { state.values(carry_.values()); }

  private:
    template <bool second>
    class Band;
    template <bool second, class Now, class Change, class Work>
    ShallowPeak in_bands(const ShallowStage<Real>& stage, const ShallowStart<Real>& start, Now& now, Change& change,
                         Work work);

    int nx_, ny_;
    bool periodic_x_, periodic_y_;
    /// What rounding has kept from the rise so far, to be given back with the next step: else what a film gives to deep
    /// water would be lost, and in single precision the volume would drift.
    Field<Real> carry_;
    std::vector<Field<Real>> scratch_;  ///< of each thread
};

}  // namespace waterlight
