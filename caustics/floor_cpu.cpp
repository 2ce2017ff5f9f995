// The floor map on the CPU: pass 0 and its ledger here, passes 1 and 2 in floor_collect and floor_spread.
#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "caustics/floor.hpp"
#include "caustics/floor_collect.hpp"
#include "caustics/floor_frame.hpp"
#include "caustics/floor_row_ledger.hpp"
#include "caustics/floor_samples.hpp"
#include "caustics/surface_rows.hpp"

namespace waterlight {

namespace {

/// Scratch rows of one thread.
struct RowScratch {
    SurfaceRows::Scratch surface;
    SampleRow samples;
    std::vector<float> path, incident, transmitted;
    Shares shares;
    RowScratch(const SurfaceRows& rows, int count)
        : surface(rows.scratch()), samples(count), path(count), incident(count), transmitted(count), shares(count) {}
};

/// Pass 0 for one row: where the light of each sample lands, and with what power.
void land_row(const FloorFrame& frame, RowScratch& scratch, float* __restrict x, float* __restrict y,
              float* __restrict power) {
    const int count = frame.columns.count;
    const f32::FloorLight light = frame.light;
    const float* __restrict elevation = scratch.samples.elevation.data();
    const float* __restrict slope_x = scratch.samples.slope_x.data();
    const float* __restrict slope_y = scratch.samples.slope_y.data();
    const float* __restrict lit = scratch.samples.lit.data();
    float* __restrict path = scratch.path.data();
    float* __restrict incident = scratch.incident.data();
    float* __restrict transmitted = scratch.transmitted.data();
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const f32::FloorSample s = f32::land_on_floor(light, elevation[i], f32::real2(slope_x[i], slope_y[i]));
        x[i] = s.displacement.x;
        y[i] = s.displacement.y;
        path[i] = s.path;
        incident[i] = lit[i] * s.incident;
        transmitted[i] = lit[i] * s.transmitted;
        power[i] = transmitted[i];
    }
    if (frame.extinction_per_m == 0) return;
    for (int i = 0; i < count; ++i) power[i] *= f32::beer_lambert(frame.extinction_per_m, path[i]);
}

/// The part of each sample's box that the window sees and, of that, what lies on the map.
void share_span(const FloorFrame& frame, int j, Span span, RowScratch& scratch, const float* __restrict x,
                const float* __restrict y) {
    const float first = static_cast<float>(frame.columns.first), base_y = static_cast<float>(frame.rows.first + j);
    const float half_x = static_cast<float>(frame.half_samples()), half_y = static_cast<float>(frame.half_channels());
    const float width = static_cast<float>(frame.map_width), height = static_cast<float>(frame.map_height);
    float* __restrict in_window = scratch.shares.in_window.data();
    float* __restrict on_map = scratch.shares.on_map.data();
#pragma GCC ivdep
    for (int i = span.begin; i < span.end; ++i) {
        const f32::AxisShare sx = f32::share_on_axis(x[i], first + static_cast<float>(i), half_x, width);
        const f32::AxisShare sy = f32::share_on_axis(y[i], base_y, half_y, height);
        in_window[i] = sx.in_window * sy.in_window;
        on_map[i] = sx.on_map * sy.on_map;
    }
}

class FloorCpu final : public FloorMapper {
  public:
    explicit FloorCpu(const FloorSettings& settings) : settings_(settings), shadows_(settings) {}

    std::string_view backend() const override { return "cpu"; }

    void compute(const Surface& surface, FloorMap& map) override {
        const FloorFrame frame = prepare(settings_, surface);
        if (map.irradiance.nx() != frame.map_width || map.irradiance.ny() != frame.map_height)
            map.irradiance = Field<float>(frame.map_width, frame.map_height);
        map.window = frame.window;
        std::vector<RowLedger> rows(frame.rows.count);
        const SurfaceRows reader(frame, surface);
        land(frame, reader, shadows_.cast(surface, frame), rows);
        const double sum = frame.adaptive ? spreader_.collect(frame, reader, landed_, map.irradiance, rows)
                                          : collector_.collect(frame, landed_, map.irradiance);
        map.ledger = total(rows, frame.pixel_area_m2);
        map.ledger.floor_w = frame.pixel_area_m2 * sum;
    }

  private:
    /// Takes from the ledger of row j what the paper's footprint does not lay on the map. Far from the map's edges,
    /// where a row's light stays in the window, there is nothing to look for.
    void share_boxes(const FloorFrame& frame, int j, RowScratch& scratch, RowLedger& row) {
        const int count = frame.columns.count, half_x = frame.half_samples(), half_y = frame.half_channels();
        const float *x = landed_.x.row(j), *y = landed_.y.row(j), *power = landed_.power.row(j);
        const auto [left, right] = range_of(x, count);
        const float low = landed_.lowest[j], high = landed_.highest[j];
        const float base = static_cast<float>(frame.rows.first + j);
        const bool plain = left >= -half_x && right <= half_x && low >= -half_y && high <= half_y && base + low >= 0 &&
                           base + high <= static_cast<float>(frame.map_height - 1);
        const Span inner = plain ? inner_columns(frame) : Span{0, 0};
        for (const Span outer : {Span{0, inner.begin}, Span{inner.end, count}}) {
            share_span(frame, j, outer, scratch, x, y);
            sum_outer(scratch.samples.counted.data(), power, scratch.shares, outer, row);
        }
    }

    /// Pass 0, with the ledger of everything but the floor.
    void land(const FloorFrame& frame, const SurfaceRows& reader, const ShadowRows& shadows,
              std::vector<RowLedger>& rows) {
        landed_.resize(frame);
#pragma omp parallel
        {
            RowScratch scratch(reader, frame.columns.count);
#pragma omp for schedule(static)
            for (int j = 0; j < frame.rows.count; ++j) {
                float *x = landed_.x.row(j), *y = landed_.y.row(j), *power = landed_.power.row(j);
                reader.read(j, scratch.surface, scratch.samples);
                land_row(frame, scratch, x, y, power);
                std::tie(landed_.lowest[j], landed_.highest[j]) = range_of(y, frame.columns.count);
                const SampleRowPowers powers{scratch.samples.counted.data(), scratch.incident.data(),
                                             scratch.transmitted.data(), power};
                sum_row(powers, frame.columns.count, rows[j]);
                shade_row(shadows.row(j), powers, power, rows[j]);
                if (!frame.adaptive) share_boxes(frame, j, scratch, rows[j]);
            }
        }
    }

    FloorSettings settings_;
    ObjectShadows shadows_;
    LandedSamples landed_;
    FloorCollector collector_;
    FloorSpreader spreader_;
};

}  // namespace

std::unique_ptr<FloorMapper> make_floor_cpu(const FloorSettings& settings) {
    validate(settings);
    if (settings.samples_per_pixel == 1) return std::make_unique<FloorCpu>(settings);
    return average_samples(settings, make_floor_cpu(one_sample_a_pixel(settings)));
}

}  // namespace waterlight
