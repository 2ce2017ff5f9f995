// What a back-end of the shallow-water model does: it keeps the state and takes steps.
#pragma once

#include "sim/shallow_check.hpp"
#include "sim/shallow_rows.hpp"
#include "sim/shallow_water.hpp"

namespace waterlight {

/// What a stage needs to know besides the fields.
template <class Real>
struct ShallowStage {
    Real dt = 0;
    Real per_dx = 0, per_dy = 0;  ///< 1/m
    Real gravity = 0;
    Real film = 0;      ///< m; see flow_per_discharge()
    Real friction = 0;  ///< g n^2 dt, applied at the end of the step where it is above 0
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
                .friction = static_cast<Real>(gravity * manning * manning * dt)};
    }
};

/// What a stage saw of its result.
struct ShallowPeak {
    double rate = 0;  ///< 1/s, largest crossing_rate()
    bool finite = true;
};

/// How the grid ends. Periodic: the frame along that axis is what lies on the other side. Closed: no water passes there,
/// not even by rounding.
struct ShallowEdges {
    bool periodic_x = false, periodic_y = false;
    bool closed_west = false, closed_east = false, closed_south = false, closed_north = false;
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
    /// Heun's method from time_s to time_s + dt: change = dt L(u), then u += (change + dt L(u + change)) / 2; friction
    /// follows.
    virtual ShallowPeak step(double time_s, double dt) = 0;
    /// Adds the fields, as they are at time_s, to the records.
    virtual void record(double time_s) = 0;
    /// Valid until the next step.
    virtual const ShallowRecords& records() = 0;
};

}  // namespace waterlight
