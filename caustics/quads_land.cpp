#include "caustics/quads_land.hpp"

#include <omp.h>

#include <cmath>
#include <cstdint>
#include <tuple>

#include "caustics/floor_row_ledger.hpp"
#include "caustics/quads_cut.hpp"
#include "caustics/surface_rows.hpp"

namespace waterlight {

namespace {

/// One row of corners. Powers in W/m2 of surface.
struct CornerRow {
    SampleRow surface;
    std::vector<float> x, y, incident, transmitted, arrived;
    float lowest = 0, highest = 0;  ///< of y
    float reach_x = 0;              ///< the largest |x|
    explicit CornerRow(int count)
        : surface(count), x(count), y(count), incident(count), transmitted(count), arrived(count) {}
};

void land_corners(const FloorFrame& corners, CornerRow& row) {
    const int count = corners.columns.count;
    const f32::FloorLight light = corners.light;
    const float* __restrict elevation = row.surface.elevation.data();
    const float* __restrict slope_x = row.surface.slope_x.data();
    const float* __restrict slope_y = row.surface.slope_y.data();
    float* __restrict x = row.x.data();
    float* __restrict y = row.y.data();
    float* __restrict incident = row.incident.data();
    float* __restrict transmitted = row.transmitted.data();
    float* __restrict arrived = row.arrived.data();
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const f32::FloorSample s = f32::land_on_floor(light, elevation[i], f32::real2(slope_x[i], slope_y[i]));
        x[i] = s.displacement.x;
        y[i] = s.displacement.y;
        incident[i] = s.incident;
        transmitted[i] = s.transmitted;
        arrived[i] = s.transmitted * f32::beer_lambert(corners.extinction_per_m, s.path);
    }
    std::tie(row.lowest, row.highest) = range_of(row.y.data(), count);
    const auto [left, right] = range_of(row.x.data(), count);
    row.reach_x = std::max(-left, right);
}

/// Powers of a row of quads, W/m2 of surface.
struct QuadPowers {
    std::vector<float> lit, counted, incident, transmitted;
    explicit QuadPowers(int count) : lit(count), counted(count), incident(count), transmitted(count) {}
};

/// The sun as the map's axes see it, for the slope of a quad from the elevations of its corners.
struct QuadSun {
    f32::real3 direction;
    float irradiance, per_x, per_y;

    QuadSun(const FloorFrame& frame, const FloorPlan& plan)
        : direction(f32::dot(f32::real2(frame.light.direction), f32::real2(plan.axis_x())),
                    f32::dot(f32::real2(frame.light.direction), f32::real2(plan.axis_y())), frame.light.direction.z),
          irradiance(frame.light.irradiance),
          per_x(static_cast<float>(0.5 / plan.pitch_m.x)),
          per_y(static_cast<float>(0.5 / plan.pitch_m.y)) {}
};

/// Powers of the quads between two rows of corners. What falls on one is what its vector area takes of the sun, so that
/// without refraction landed power over landed area is even; of that enters and arrives as much as at its corners.
void fill_quads(const QuadSun& sun, const CornerRow& low, const CornerRow& high, QuadPowers& quads,
                float* __restrict arrived) {
    const float* __restrict e0 = low.surface.elevation.data();
    const float* __restrict e1 = high.surface.elevation.data();
    const float* __restrict i0 = low.incident.data();
    const float* __restrict i1 = high.incident.data();
    const float* __restrict t0 = low.transmitted.data();
    const float* __restrict t1 = high.transmitted.data();
    const float* __restrict a0 = low.arrived.data();
    const float* __restrict a1 = high.arrived.data();
    const float* __restrict lit = quads.lit.data();
    float* __restrict incident = quads.incident.data();
    float* __restrict transmitted = quads.transmitted.data();
    const QuadSun s = sun;
    const int count = static_cast<int>(quads.lit.size());
    constexpr float none = 1e-30F;
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const f32::real2 slope(s.per_x * ((e0[i + 1] - e0[i]) + (e1[i + 1] - e1[i])),
                               s.per_y * ((e1[i] - e0[i]) + (e1[i + 1] - e0[i + 1])));
        const float falls = lit[i] * s.irradiance * f32::incident_factor(s.direction, slope);
        const float each = falls / f32::max(none, (i0[i] + i0[i + 1]) + (i1[i] + i1[i + 1]));
        incident[i] = falls;
        transmitted[i] = each * ((t0[i] + t0[i + 1]) + (t1[i] + t1[i + 1]));
        arrived[i] = each * ((a0[i] + a0[i + 1]) + (a1[i] + a1[i + 1]));
    }
}

class QuadLander {
  public:
    QuadLander(const FloorFrame& frame, const FloorSettings& settings, const Surface& surface,
               const ShadowRows& shadows)
        : frame_(frame),
          shadows_(shadows),
          corners_(corners_of(frame, settings, surface)),
          quad_rows_(frame_, surface),
          corner_rows_(corners_, surface),
          sun_(frame, settings.plan),
          cutter_(frame, settings, surface) {}

    const FloorFrame& corners() const { return corners_; }

    /// Lands rows [begin, end) of quads; returns the largest displacement of their corners along each axis.
    glm::vec2 land(int begin, int end, LandedQuads& landed, std::vector<RowLedger>& ledger) const {
        SurfaceRows::Scratch scratch = corner_rows_.scratch();
        CornerRow low(corners_.columns.count), high(corners_.columns.count);
        QuadPowers quads(frame_.columns.count);
        land_row(begin, scratch, high);
        glm::vec2 reach = reach_of(high);
        for (int j = begin; j < end; ++j) {
            std::swap(low, high);
            keep(low, j, landed);
            land_row(j + 1, scratch, high);
            reach = glm::max(reach, reach_of(high));
            landed.corners.lowest[j] = std::min(low.lowest, high.lowest);
            // Two rows more: a block of pixels may reach beyond its quad, and get what rounding gives.
            landed.corners.highest[j] = std::max(low.highest, high.highest) + 2;
            read_parts(j, quads, landed.pieces[j], ledger[j]);
            float* arrived = landed.corners.power.row(j);
            fill_quads(sun_, low, high, quads, arrived);
            const SampleRowPowers powers{quads.counted.data(), quads.incident.data(), quads.transmitted.data(),
                                         arrived};
            sum_row(powers, frame_.columns.count, ledger[j]);
            shade_row(shadows_.row(j), powers, arrived, ledger[j]);
        }
        if (end == frame_.rows.count) keep(high, end, landed);
        return reach;
    }

  private:
    void land_row(int j, SurfaceRows::Scratch& scratch, CornerRow& row) const {
        corner_rows_.read(j, scratch, row.surface);
        land_corners(corners_, row);
    }

    static glm::vec2 reach_of(const CornerRow& row) { return {row.reach_x, std::max(-row.lowest, row.highest)}; }

    static void keep(const CornerRow& row, int j, LandedQuads& landed) {
        std::ranges::copy(row.x, landed.corners.x.row(j));
        std::ranges::copy(row.y, landed.corners.y.row(j));
    }

    /// What of each quad is lit and counted. Quads that a wall cuts are landed here by themselves and not lit any more.
    void read_parts(int j, QuadPowers& quads, std::vector<CutPiece>& pieces, RowLedger& row) const {
        pieces.clear();
        quad_rows_.read_counted(j, quads.counted);
        quad_rows_.read_lit(j, quads.lit);
        if (!cutter_.cuts()) return;
        constexpr float all = 1 - 1e-6F;
        for (int i = 0; i < frame_.columns.count; ++i) {
            if (quads.lit[i] >= all) continue;
            if (quads.lit[i] > 0)
                cutter_.cut({frame_.columns.first + i, frame_.rows.first + j}, quads.counted[i], shadows_.of(i, j),
                            pieces, row);
            quads.lit[i] = 0;
        }
    }

    const FloorFrame& frame_;
    const ShadowRows& shadows_;
    FloorFrame corners_;
    SurfaceRows quad_rows_, corner_rows_;
    QuadSun sun_;
    QuadCutter cutter_;
};

}  // namespace

void land_quads(FloorFrame& frame, const FloorSettings& settings, const Surface& surface, const ShadowRows& shadows,
                LandedQuads& landed, std::vector<RowLedger>& ledger) {
    const QuadLander lander(frame, settings, surface, shadows);
    landed.corners.resize(lander.corners());
    landed.pieces.resize(frame.rows.count);
    glm::vec2 reach{0, 0};
#pragma omp parallel
    {
        const std::int64_t rows = frame.rows.count;
        const int threads = omp_get_num_threads(), me = omp_get_thread_num();
        const int begin = static_cast<int>(rows * me / threads), end = static_cast<int>(rows * (me + 1) / threads);
        const glm::vec2 mine = begin < end ? lander.land(begin, end, landed, ledger) : glm::vec2{0, 0};
#pragma omp critical
        reach = glm::max(reach, mine);
    }
    // Of cut pieces, too: they are within their quads.
    constexpr float farthest = 1 << 23;
    const glm::ivec2 half(glm::ceil(glm::min(reach, glm::vec2(farthest))));
    frame.window.samples = std::max(frame.window.samples, 2 * half.x + 1);
    frame.window.channels = std::max(frame.window.channels, 2 * half.y + 1);
}

}  // namespace waterlight
