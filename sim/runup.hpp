// How far up the ground the water has come.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "sim/field.hpp"
#include "sim/grid.hpp"

namespace waterlight {

/// A place to which the water came, and the height of the ground there (m above level 0).
struct RunupPoint {
    glm::dvec2 at_m{0, 0};
    double ground_m = 0;
};

/// Points in order along it, no two neighbours the same; of a closed line the first comes again as the last.
using RunupLine = std::vector<RunupPoint>;

/// The lines between the cells that ever were wet and those that never were. Between two neighbours' centres the ground
/// is taken as straight and the highest water as level: the line lies where they meet, at the dry centre where the
/// water stood higher than that, half-way where the dry ground lies below the water's own. Second order in the cell
/// size where the highest water is level across the shore, else first, with an error of (its slope / the ground's) of a
/// cell. `bed_m` is the ground above level 0, `max_elevation_m` the highest water, NaN where there never was any (as in
/// ShallowRecords); both have the size of the grid. Lines end at the centres of the outermost cells.
std::vector<RunupLine> runup_lines(const Grid& grid, const Field<float>& bed_m, const Field<float>& max_elevation_m);

/// The centre of the highest cell that ever was wet, and its ground; none where all stayed dry.
std::optional<RunupPoint> highest_runup(const Grid& grid, const Field<float>& bed_m,
                                        const Field<float>& max_elevation_m);

}  // namespace waterlight
