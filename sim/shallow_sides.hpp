// What lies beyond the sides of the shallow-water model: fills the frames of its fields.
#pragma once

#include <array>
#include <utility>

#include "sim/boundary.hpp"
#include "sim/grid.hpp"
#include "sim/kernels/shallow_sides.hpp"
#include "sim/shallow_rows.hpp"
#include "sim/shallow_solver.hpp"
#include "sim/shallow_water.hpp"

namespace waterlight {

/// As waves of light and drops see the sides: an axis of which one side is a wall or a piston is walled; one that lets
/// water pass on both sides absorbs.
Boundary boundary_of(const ShallowSides& sides);

/// Of west, east, south and north.
using SideDemands = std::array<f64::SideDemand, 4>;

/// When sides are asked for what they do: at_s within the step from from_s to to_s, all the same where no step is
/// taken.
struct ShallowMoment {
    double at_s, from_s, to_s;
};

/// What the sides ask for. A piston has its mean velocity over the step, so that it goes all of its way.
SideDemands side_demands(const ShallowSides& sides, const ShallowMoment& moment);

/// Nothing passes a wall; a river has its discharge.
ShallowGates gates_of(const SideDemands& demands);

/// Whether a side does what a series says.
bool has_series(const ShallowSides& sides);

namespace shallow_sides {
struct SideView;
}

template <class Real>
class ShallowFrames {
  public:
    /// Of films thinner than `film` (m) the velocity fades, see flow_per_discharge().
    ShallowFrames(const Grid& grid, double gravity_m_s2, double film_m);

    /// The frame of the ground and of the initial surface: mirrored at walls, repeated where periodic, level elsewhere.
    void fill(const SideDemands& demands, ShallowStart<Real>& start) const;

    /// The frame of the fields. Returns the largest crossing rate (1/s) of what may flow in.
    double fill(const SideDemands& demands, const ShallowStart<Real>& start, ShallowFields<Real>& now) const;

    /// The frame of `change`, such that now + change is what lies beyond the sides.
    void fill(const SideDemands& demands, const ShallowStart<Real>& start, const ShallowFields<Real>& now,
              ShallowFields<Real>& change) const;

  private:
    /// Of each frame cell of a side what lies beyond: cells.first gives what is inside, cells.second takes what is
    /// beyond.
    template <class Inside, class Put>
    double find_beyond(const f64::SideDemand& demand, const shallow_sides::SideView& view,
                       const ShallowStart<Real>& start, const std::pair<Inside, Put>& cells) const;

    Grid grid_;
    double gravity_, film_;
};

extern template class ShallowFrames<float>;
extern template class ShallowFrames<double>;

}  // namespace waterlight
