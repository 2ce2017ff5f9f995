// How wrong a wave model's surface is, by the same model on other grids alongside.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "app/floor_stage.hpp"
#include "scenarios/build.hpp"

namespace waterlight {

/// airy is exact in time, and what the grid leaves out of its initial state and its sources vanishes faster than any
/// power of the cell: it is compared with three times as many cells along each side, whose error is small beside its
/// own and whose cells have among them the places of its own. linear is of second order, so that its error is a third
/// of its difference from the solution on half as many cells (Richardson). shallow-water is of second order where the
/// water is smooth and of first at shocks: its order is measured with a quarter of the cells too, and taken between one
/// and two.
class WaveEstimate {
  public:
    /// Builds the other models. The scenario's model is not prescribed.
    WaveEstimate(const Scenario& scenario, const BackendDecision& backend);

    /// With the model itself.
    void advance(double seconds);
    /// Likewise; throw as its own.
    void disturb(std::span<const Disturbance> disturbances);
    void set_rain(std::span<const Rain> rain);
    void compute(const Surface& surface);
    /// Gives the state of the other models to the archive, or takes it from there. The next frame computes the rest.
    void exchange_state(StateArchive& state);

    /// Surface less exact surface, m, at the cells; 0 on dry ground.
    const Field<float>& error() const { return error_; }
    /// RMS of that over the RMS of the elevation, of wet cells; NaN where the water is still.
    double rmse() const { return rmse_; }

  private:
    /// How much smaller the error gets with half the cell: within [least, most].
    struct Gain {
        double least, most;
    };
    Field<float> difference(const Surface& finer, WaveModel& other) const;

    bool is_finer_;  ///< the first of the others has more cells
    Gain gain_;
    std::vector<BuiltModel> others_;  ///< towards coarser
    Field<float> error_;
    double rmse_ = 0;
};

}  // namespace waterlight
