// The ground as rays in the water meet it.
#pragma once

#include <algorithm>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "sim/boundary.hpp"
#include "sim/field.hpp"
#include "sim/grid.hpp"

namespace waterlight {

/// Heights of the ground, bilinear between the centres of cells. Beyond periodic sides they repeat; beyond others the
/// outermost cells go on.
class BeamGround {
  public:
    /// Heights in m above still water, on the cells of `grid`. Throws InputError where they are not on it or not
    /// finite.
    BeamGround(const Grid& grid, Boundary boundary, Field<float> height_m);

    double height_m(glm::dvec2 at_m) const;
    double lowest_m() const { return lowest_; }
    double highest_m() const { return highest_; }
    /// Of a cell, the smaller: on which the ground is even.
    double step_m() const { return std::min(grid_.dx_m, grid_.dy_m); }

    /// The height at which a ray from a place in the water first meets the ground; `travel` in horizontal metres per
    /// metre of descent. Where the water is no deeper than `film_m`, so much above
    /// the ground below or the place, whichever is higher: such a ray has no way. The march is in steps of a cell.
    double end_z(glm::dvec3 from_m, glm::dvec2 travel) const;

    /// Depth (m) of water below which ground counts as dry: above the rounding of heights of some 100 m.
    static constexpr double film_m = 1e-5;

  private:
    Grid grid_;
    Boundary boundary_;
    Field<float> height_;
    double lowest_ = 0, highest_ = 0;
};

}  // namespace waterlight
