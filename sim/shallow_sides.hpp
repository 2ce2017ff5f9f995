// What lies beyond the sides of the shallow-water model: fills the frames of its fields.
#pragma once

#include "sim/boundary.hpp"
#include "sim/grid.hpp"
#include "sim/shallow_rows.hpp"
#include "sim/shallow_sweep.hpp"
#include "sim/shallow_water.hpp"

namespace waterlight {

/// As waves of light and drops see the sides: an axis of which one side is a wall or a piston is walled; one that lets
/// water pass on both sides absorbs.
Boundary boundary_of(const ShallowSides& sides);

namespace shallow_sides {
struct SideView;
struct Moment;
}  // namespace shallow_sides

/// The step in which sides are asked for what they do. Before it is known how long it is, from and to are the same.
struct ShallowMoment {
    double from_s, to_s;
};

template <class Real>
class ShallowFrames {
  public:
    /// Of films thinner than `film` (m) the velocity fades, see flow_per_discharge().
    ShallowFrames(const Grid& grid, const ShallowSides& sides, double gravity_m_s2, double film_m);

    /// What passes walls and rivers at time_s.
    ShallowGates gates(double time_s) const;

    /// The frame of the ground and of the initial surface: mirrored at walls, repeated where periodic, level elsewhere.
    void fill(ShallowStart<Real>& start) const;

    /// The frame of the fields at the start of the step; a piston has its mean velocity over the step, so that it goes
    /// all of its way. Returns the largest crossing rate (1/s) of what may flow in.
    double fill(const ShallowStart<Real>& start, const ShallowMoment& step, ShallowFields<Real>& now) const;

    /// The frame of `change`, such that now + change is what lies beyond the sides at the end of the step.
    void fill(const ShallowStart<Real>& start, const ShallowMoment& step, const ShallowFields<Real>& now,
              ShallowFields<Real>& change) const;

    /// Whether a side does what a series says.
    bool has_series() const;

  private:
    /// Of each frame cell of a side what lies beyond: cells.first gives what is inside, cells.second takes what is
    /// beyond.
    template <class Inside, class Put>
    double find_beyond(const ShallowSide& side, const shallow_sides::SideView& view, const ShallowStart<Real>& start,
                       const shallow_sides::Moment& moment, const std::pair<Inside, Put>& cells) const;

    Grid grid_;
    ShallowSides sides_;
    double gravity_, film_;
};

extern template class ShallowFrames<float>;
extern template class ShallowFrames<double>;

}  // namespace waterlight
