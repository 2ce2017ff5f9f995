// What a back-end of the shallow-water model does: it keeps the state and takes steps.
#pragma once

#include "sim/shallow_check.hpp"
#include "sim/shallow_rows.hpp"
#include "sim/shallow_water.hpp"

namespace waterlight {

/// A side through which the flow is given, exactly and not as it comes out between inside and frame: none at walls.
struct ShallowGate {
    bool given = false;
    double discharge_m2_s = 0;  ///< along the axis
};
struct ShallowGates {
    ShallowGate west, east, south, north;
};

/// What a stage needs to know besides the fields.
template <class Real>
struct ShallowStage {
    Real dt = 0;
    Real per_dx = 0, per_dy = 0;  ///< 1/m
    Real gravity = 0;
    Real film = 0;      ///< m; see flow_per_discharge()
    Real friction = 0;  ///< g n^2 dt / 2: half of the step's friction goes before it, half after it (Strang)
    ShallowGates gates = {};
};

/// What is the same for all stages of a run.
struct ShallowConstants {
    double per_dx, per_dy, gravity, manning, film, wet;

    explicit ShallowConstants(const ShallowWaterSettings& s)
        : per_dx(1 / s.grid.dx_m),
          per_dy(1 / s.grid.dy_m),
          gravity(s.water.gravity_m_s2),
          manning(s.manning),
          film(film_depth(s)),
          wet(s.wet_m) {}

    /// A stage of a step of dt seconds.
    template <class Real>
    ShallowStage<Real> stage(double dt) const {
        return {.dt = static_cast<Real>(dt),
                .per_dx = static_cast<Real>(per_dx),
                .per_dy = static_cast<Real>(per_dy),
                .gravity = static_cast<Real>(gravity),
                .film = static_cast<Real>(film),
                .friction = static_cast<Real>(0.5 * gravity * manning * manning * dt)};
    }
};

/// What a stage saw of its result.
struct ShallowPeak {
    double rate = 0;  ///< 1/s, largest crossing_rate()
    bool finite = true;
};

template <class Real>
class ShallowSolver {
  public:
    virtual ~ShallowSolver() = default;

    /// The initial surface and depth, frame included.
    virtual const ShallowStart<Real>& start() const = 0;
    /// The fields as they are now, frame included. What is written to them counts from the next look() on.
    virtual ShallowFields<Real>& fields() = 0;
    /// Settles the discharge of films and fills the frame, as a step does at its end. The peak is that of the fields
    /// and of what may flow in.
    virtual ShallowPeak look(double time_s) = 0;
    /// Heun's method from time_s to time_s + dt: change = dt L(u), then u += (change + dt L(u + change)) / 2; half of
    /// the friction before it, half after.
    virtual ShallowPeak step(double time_s, double dt) = 0;
    /// Adds the fields, as they are at time_s, to the records.
    virtual void record(double time_s) = 0;
    /// Valid until the next step.
    virtual const ShallowRecords& records() = 0;
    /// As WaveModel's: the fields and the records.
    virtual void exchange_state(StateArchive& state) = 0;
};

}  // namespace waterlight
