// The surface's fields as the passes read them: with a margin that tells the sides, and ever coarser.
#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "sim/surface.hpp"

namespace waterlight {

/// nx by ny cells, each `scale` of the surface's own along both axes, and around them a margin of one.
struct SurfaceLevel {
    int offset = 0;  ///< of the margin's first cell
    int nx = 1;
    int ny = 1;
    float scale = 1;
};

/// Slopes, the variance per axis of slopes within the cell, elevation (m) of each cell. A cell of a coarser level holds
/// means over four of the finer, and in the variance what those differ by (Olano & Baker, "LEAN mapping", 2010, of
/// which this is the isotropic part).
struct SurfaceLevels {
    std::vector<glm::vec4> cells;
    std::vector<SurfaceLevel> levels;  ///< finest first
    SurfaceLevel beyond;               ///< one cell: what the water is far away
    double mean_variance = 0;          ///< of all slopes, per axis
    double curvature_per_m = 0;        ///< change of slope per metre, root mean square
    double lowest_m = 0, highest_m = 0;
};

/// Where `ground` is not null, cells of which it rises out of the water take the level of the wet beside them, or lie
/// below the ground: the shore is where the two meshes cross.
void fill_levels(const Surface& surface, const Field<float>* ground_m, SurfaceLevels& levels);

/// The ground's heights with a margin of one cell, as high as the cells beside it.
std::vector<float> padded_ground(const Surface& surface, const Field<float>& ground_m);

}  // namespace waterlight
