// What every wave model offers.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "sim/disturbance.hpp"
#include "sim/state_archive.hpp"
#include "sim/surface.hpp"

namespace waterlight {

/// Integrals over the domain, accumulated in double.
struct WaveDiagnostics {
    double volume_m3 = 0;       ///< integral of elevation
    double energy_j = 0;        ///< potential + kinetic + capillary; NaN where the model has no dynamics
    double variance_m2 = 0;     ///< m0: mean of elevation squared, about its mean
    double slope_variance = 0;  ///< mean of slope_x^2 + slope_y^2
    double max_abs_elevation_m = 0;
};

class WaveModel {
  public:
    virtual ~WaveModel() = default;

    /// The name a scenario uses.
    virtual std::string_view name() const = 0;
    /// Moves the state forward by frame_s >= 0 seconds, in as many stable sub-steps as it takes.
    virtual void advance(double frame_s) = 0;
    /// Disturbs the water now, between calls of advance(): the elevation changes at once, the volume does not. A drop
    /// leads to what a source of the settings leads to that falls at this time; where time goes by steps it comes, as
    /// there, at the first step at or after it. Throws InputError where a number is out of its range, or where the
    /// surface is prescribed; then nothing has changed.
    virtual void disturb(std::span<const Disturbance> disturbances) = 0;
    /// From now on it rains like this, in the place of what rain there was. Throws InputError as disturb().
    virtual void set_rain(std::span<const Rain> rain) = 0;
    /// The surface at the present time, slopes included. Valid until the next advance().
    virtual const Surface& surface() = 0;
    virtual WaveDiagnostics diagnostics() = 0;
    /// Sub-steps taken since the start.
    virtual std::int64_t steps() const = 0;
    /// Gives its state to the archive or takes it from there; between calls of advance(). A model of the same settings
    /// on the same back-end then goes on bit by bit as the one did that gave it.
    virtual void exchange_state(StateArchive& state) = 0;
};

}  // namespace waterlight
