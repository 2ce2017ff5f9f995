// What lies beyond the sides of the shallow-water model: fills the frames of its fields.
#pragma once

#include "sim/boundary.hpp"
#include "sim/grid.hpp"
#include "sim/shallow_rows.hpp"
#include "sim/shallow_water.hpp"

namespace waterlight {

/// As waves of light and drops see the sides: an axis of which one side is a wall or a piston is walled; one that lets
/// water pass on both sides absorbs.
Boundary boundary_of(const ShallowSides& sides);

template <class Real>
class ShallowFrames {
  public:
    /// Of films thinner than `film` (m) the velocity fades, see flow_per_discharge().
    ShallowFrames(const Grid& grid, const ShallowSides& sides, double gravity_m_s2, double film_m);

    /// The frame of the ground and of the initial surface: mirrored at walls, repeated where periodic, level elsewhere.
    void fill(ShallowStart<Real>& start) const;

    /// The frame of the fields at time_s. Returns the largest crossing rate (1/s) of what may flow in.
    double fill(const ShallowStart<Real>& start, double time_s, ShallowFields<Real>& fields) const;

  private:
    Grid grid_;
    ShallowSides sides_;
    double gravity_, film_;
};

extern template class ShallowFrames<float>;
extern template class ShallowFrames<double>;

}  // namespace waterlight
