#include "app/exact_surface.hpp"

namespace waterlight {

TruthSurface exact_surface(const Surface& surface, const SurfaceFormula* formula) {
    TruthSurface exact = interpolate(surface);
    if (!formula) return exact;
    exact.at = [formula, &surface](glm::dvec2 at_m) {
        const Grid& g = surface.grid;
        const bool still = beyond(surface.boundary.x, g.x0_m, g.width_m(), at_m.x) ||
                           beyond(surface.boundary.y, g.y0_m, g.height_m(), at_m.y);
        return still ? SurfacePoint{} : formula->at(at_m, surface.time_s);
    };
    return exact;
}

}  // namespace waterlight
