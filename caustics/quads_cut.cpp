#include "caustics/quads_cut.hpp"

#include "caustics/floor_row_ledger.hpp"
#include "caustics/landed_corner.hpp"
#include "caustics/polygon.hpp"
#include "caustics/surface_point.hpp"

namespace waterlight {

QuadCutter::QuadCutter(const FloorFrame& frame, const FloorSettings& settings, const Surface& surface)
    : frame_(frame),
      settings_(settings),
      walls_(surface.boundary.x == Side::wall, surface.boundary.y == Side::wall),
      low_m_(surface.grid.x0_m, surface.grid.y0_m),
      high_m_(low_m_ + glm::dvec2{surface.grid.width_m(), surface.grid.height_m()}),
      surface_{surface.grid, surface.boundary, [&surface](glm::dvec2 at) { return surface_point(surface, at); }},
      caster_(settings, surface_) {}

void QuadCutter::cut(glm::ivec2 base, double counted, const f64::SampleShadow* shadow, std::vector<CutPiece>& pieces,
                     RowLedger& row) const {
    Polygon water;
    for (const glm::dvec2 corner : {glm::dvec2{0, 0}, {1, 0}, {1, 1}, {0, 1}})
        water.add(entry_m(frame_, settings_, glm::dvec2(base) + corner));
    for (int axis = 0; axis < 2; ++axis) {
        if (!walls_[axis]) continue;
        water = clip(clip(water, axis, low_m_[axis], 1), axis, high_m_[axis], -1);
    }
    if (water.count < 3) return;

    std::array<LandedCorner, 8> landed;
    for (int k = 0; k < water.count; ++k) {
        const TruthRay ray = caster_.cast(water.corner[k]);
        landed[k] = {ray.start_m, settings_.plan.pixel(ray.floor_m), ray.transmittance, ray.remaining};
    }
    const double per_pixel = caster_.irradiance() / frame_.pixel_area_m2;
    for (int k = 1; k + 1 < water.count; ++k) {
        const TrianglePower power = triangle_power(landed[0], landed[k], landed[k + 1], caster_.direction());
        const double incident = per_pixel * power.incident, entered = per_pixel * power.entered;
        double arrived = per_pixel * power.arrived;
        row.incident += counted * incident;
        row.reflected += counted * (incident - entered);
        row.extinguished += counted * (entered - arrived);
        row.entered += (1 - counted) * arrived;
        if (shadow != nullptr) {
            shade_sample(*shadow, counted, incident, entered, arrived, row);
            arrived = f64::shade(*shadow, incident, entered, arrived).arrived;
        }
        pieces.push_back({{landed[0].pixel, landed[k].pixel, landed[k + 1].pixel}, arrived, counted});
    }
}

}  // namespace waterlight
