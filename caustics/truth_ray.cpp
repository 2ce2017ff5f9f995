#include "caustics/truth_ray.hpp"

#include <cmath>

namespace waterlight {

namespace {

/// Nothing beyond a wall is lit. Where the floor rectangle covers the domain, all of the domain is followed, so that
/// the ledger accounts for what the walls take.
void limit_to_side(Side side, double from, double extent, bool covered, double& low, double& high) {
    if (side == Side::periodic) return;
    if (covered) {
        low = std::min(low, from);
        high = std::max(high, from + extent);
    }
    if (side == Side::absorbing) return;
    low = std::max(low, from);
    high = std::min(high, from + extent);
}

}  // namespace

SurfacePatch patch_above(const TruthCaster& caster, glm::dvec2 floor_low, glm::dvec2 floor_high, glm::dvec2 reach_m) {
    SurfacePatch patch{floor_low - caster.rest_shift() - reach_m, floor_high - caster.rest_shift() + reach_m};
    const TruthSurface& s = caster.surface();
    const Grid& g = s.grid;
    const double slack = 1e-9 * (g.width_m() + g.height_m());
    const bool covered = floor_low.x <= g.x0_m + slack && floor_high.x >= g.x0_m + g.width_m() - slack &&
                         floor_low.y <= g.y0_m + slack && floor_high.y >= g.y0_m + g.height_m() - slack;
    limit_to_side(s.boundary.x, g.x0_m, g.width_m(), covered, patch.low.x, patch.high.x);
    limit_to_side(s.boundary.y, g.y0_m, g.height_m(), covered, patch.low.y, patch.high.y);
    return patch;
}

glm::dvec2 largest_stray(const TruthCaster& caster, double spacing_m) {
    const Grid& grid = caster.surface().grid;
    const int nx = std::clamp(static_cast<int>(std::ceil(grid.width_m() / spacing_m)), 1, 2048);
    const int ny = std::clamp(static_cast<int>(std::ceil(grid.height_m() / spacing_m)), 1, 2048);
    double stray_x = 0, stray_y = 0;
#pragma omp parallel for schedule(static) reduction(max : stray_x, stray_y)
    for (int j = 0; j <= ny; ++j) {
        for (int i = 0; i <= nx; ++i) {
            const glm::dvec2 at{grid.x0_m + grid.width_m() * i / nx, grid.y0_m + grid.height_m() * j / ny};
            const TruthRay ray = caster.cast(at);
            if (ray.incident <= 0) continue;
            const glm::dvec2 stray = glm::abs(ray.floor_m - at - caster.rest_shift());
            stray_x = std::max(stray_x, stray.x);
            stray_y = std::max(stray_y, stray.y);
        }
    }
    return 1.1 * glm::dvec2{stray_x, stray_y} + 2 * spacing_m;
}

}  // namespace waterlight
