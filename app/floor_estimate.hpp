// How wrong a floor map is, by a better solution of the same surface.
#pragma once

#include "caustics/truth.hpp"
#include "sim/state_archive.hpp"

namespace waterlight {

class FloorEstimate {
  public:
    /// Of maps by these settings.
    explicit FloorEstimate(FloorSettings settings) : settings_(std::move(settings)) {}

    /// The better solution is the truth with as few sub-samples as do: its own last change is at most 0.3 of the error
    /// that it finds, or it has come to 32 a pixel and axis.
    void compute(const TruthSurface& surface, const Field<float>& irradiance);
    /// Gives where the next map's search begins to the archive, or takes it from there.
    void exchange_state(StateArchive& state) { state.value(subsamples_); }

    /// Map less better solution, W/m2: what to subtract from the map.
    const Field<float>& error() const { return error_; }
    /// Relative RMSE that follows.
    double rmse() const { return rmse_; }

  private:
    FloorSettings settings_;
    int subsamples_ = 1;  ///< where the next map's search begins
    Field<float> error_;
    double rmse_ = 0;
};

}  // namespace waterlight
