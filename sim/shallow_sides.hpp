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

/// What the sides ask for at time_s.
SideDemands side_demands(const ShallowSides& sides, double time_s);

/// Walls are closed; a piston brings in the water that it displaces.
ShallowEdges edges_of(const ShallowSides& sides);

namespace shallow_sides {
struct SideView;
using f64::SideDemand;
}  // namespace shallow_sides

template <class Real>
class ShallowFrames {
  public:
    /// Of films thinner than `film` (m) the velocity fades, see flow_per_discharge().
    ShallowFrames(const Grid& grid, const ShallowSides& sides, double gravity_m_s2, double film_m);

    /// The frame of the ground and of the initial surface: mirrored at walls, repeated where periodic, level elsewhere.
    void fill(ShallowStart<Real>& start) const;

    /// The frame of the fields at time_s. Returns the largest crossing rate (1/s) of what may flow in.
    double fill(const ShallowStart<Real>& start, double time_s, ShallowFields<Real>& now) const;

    /// The frame of `change`, such that now + change is what lies beyond the sides at time_s.
    void fill(const ShallowStart<Real>& start, double time_s, const ShallowFields<Real>& now,
              ShallowFields<Real>& change) const;

  private:
    /// Calls work(demand, view) for the four sides.
    template <class Work>
    void for_sides(double time_s, Work work) const;
    /// Of each frame cell of a side what lies beyond: cells.first gives what is inside, cells.second takes what is
    /// beyond.
    template <class Inside, class Put>
    double find_beyond(const f64::SideDemand& demand, const shallow_sides::SideView& view,
                       const ShallowStart<Real>& start, const std::pair<Inside, Put>& cells) const;

    Grid grid_;
    ShallowSides sides_;
    double gravity_, film_;
};

extern template class ShallowFrames<float>;
extern template class ShallowFrames<double>;

}  // namespace waterlight
