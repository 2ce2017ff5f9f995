// One stage of the shallow-water scheme, row by row: the loops around sim/kernels/shallow_water.glsl.
#pragma once

#include <vector>

#include "sim/shallow_rows.hpp"

namespace waterlight {

/// What a stage needs to know besides the fields.
template <class Real>
struct ShallowStage {
    Real dt = 0;
    Real per_dx = 0, per_dy = 0;  ///< 1/m
    Real gravity = 0;
    Real film = 0;          ///< m; see flow_per_discharge()
    Real friction = 0;      ///< g n^2 dt, applied at the end of the stage where it is above 0
    bool averages = false;  ///< Heun's second stage: the mean of `before` and the stage's own result
};

/// What a stage saw of its result.
struct ShallowPeak {
    double rate = 0;  ///< 1/s, largest crossing_rate()
    bool finite = true;
};

/// Stages for one grid. Fields are handled in bands of rows, one a thread; each row comes out the same whatever the
/// bands.
template <class Real>
class ShallowSweep {
  public:
    /// `periodic_*`: the frame along that axis is what lies on the other side.
    ShallowSweep(int nx, int ny, bool periodic_x, bool periodic_y);

    /// to = from + dt L(from), or the mean of that and what `to` held before where stage.averages. The frames of
    /// `start` and `from` are filled. The depth stays at or above 0, and what leaves a cell enters its neighbours.
    ShallowPeak run(const ShallowStage<Real>& stage, const ShallowStart<Real>& start, const ShallowFields<Real>& from,
                    ShallowFields<Real>& to);

    /// Settles the discharge of films and finds the fastest waves, as run() does at the end of a step.
    ShallowPeak look(const ShallowStage<Real>& stage, const ShallowStart<Real>& start, ShallowFields<Real>& fields);

  private:
    class Band;
    template <class Work>
    ShallowPeak in_bands(Work work);

    int nx_, ny_;
    bool periodic_x_, periodic_y_;
    std::vector<Field<Real>> scratch_;  ///< of each thread
};

}  // namespace waterlight
