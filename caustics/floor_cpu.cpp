// The floor map on the CPU: pass 0 and the ledger here, passes 1 and 2 in floor_collect.
#include <algorithm>
#include <cmath>
#include <vector>

#include "caustics/floor.hpp"
#include "caustics/floor_collect.hpp"
#include "caustics/floor_frame.hpp"
#include "caustics/surface_rows.hpp"

namespace waterlight {

namespace {

/// What one row of samples adds to the ledger, W/m2 of surface.
struct RowLedger {
    double incident = 0, reflected = 0, extinguished = 0, outside = 0, lost = 0, entered = 0;
};

/// Scratch rows of one thread.
struct RowScratch {
    SurfaceRows::Scratch surface;
    SampleRow samples;
    std::vector<float> path, incident, transmitted, on_map, in_window;
    RowScratch(const SurfaceRows& rows, int count)
        : surface(rows.scratch()),
          samples(count),
          path(count),
          incident(count),
          transmitted(count),
          on_map(count),
          in_window(count) {}
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

/// Samples [begin, end) of a row.
struct Span {
    int begin = 0;
    int end = 0;
};

/// The part of each sample's box that the window sees and, of that, what lies on the map.
void share_span(const FloorFrame& frame, int j, Span span, RowScratch& scratch, const float* __restrict x,
                const float* __restrict y) {
    const float first = static_cast<float>(frame.columns.first), base_y = static_cast<float>(frame.rows.first + j);
    const float half_x = static_cast<float>(frame.half_samples()), half_y = static_cast<float>(frame.half_channels());
    const float width = static_cast<float>(frame.map_width), height = static_cast<float>(frame.map_height);
    float* __restrict in_window = scratch.in_window.data();
    float* __restrict on_map = scratch.on_map.data();
#pragma GCC ivdep
    for (int i = span.begin; i < span.end; ++i) {
        const f32::AxisShare sx = f32::share_on_axis(x[i], first + static_cast<float>(i), half_x, width);
        const f32::AxisShare sy = f32::share_on_axis(y[i], base_y, half_y, height);
        in_window[i] = sx.in_window * sy.in_window;
        on_map[i] = sx.on_map * sy.on_map;
    }
}

/// Adds samples whose light all falls on the map and into the window.
void sum_inner(const RowScratch& scratch, const float* power, Span span, RowLedger& row) {
    const float* counted = scratch.samples.counted.data();
    const float* incident = scratch.incident.data();
    const float* transmitted = scratch.transmitted.data();
    double in = 0, reflected = 0, extinguished = 0, entered = 0;
#pragma omp simd reduction(+ : in, reflected, extinguished, entered)
    for (int i = span.begin; i < span.end; ++i) {
        in += counted[i] * incident[i];
        reflected += counted[i] * (incident[i] - transmitted[i]);
        extinguished += counted[i] * (transmitted[i] - power[i]);
        entered += (1 - counted[i]) * power[i];
    }
    row.incident += in;
    row.reflected += reflected;
    row.extinguished += extinguished;
    row.entered += entered;
}

/// Adds any samples.
void sum_outer(const RowScratch& scratch, const float* power, Span span, RowLedger& row) {
    const float* counted = scratch.samples.counted.data();
    const float* in_window = scratch.in_window.data();
    const float* on_map = scratch.on_map.data();
    double outside = 0, lost = 0, not_entered = 0;
#pragma omp simd reduction(+ : outside, lost, not_entered)
    for (int i = span.begin; i < span.end; ++i) {
        lost += counted[i] * power[i] * (1 - in_window[i]);
        outside += counted[i] * power[i] * (in_window[i] - on_map[i]);
        not_entered += (1 - counted[i]) * power[i] * (1 - on_map[i]);
    }
    sum_inner(scratch, power, span, row);
    row.lost += lost;
    row.outside += outside;
    row.entered -= not_entered;
}

/// Least and largest of a row; a NaN is passed over.
std::pair<float, float> range_of(const float* row, int count) {
    float low = 0, high = 0;
#pragma omp simd reduction(min : low) reduction(max : high)
    for (int i = 0; i < count; ++i) {
        low = row[i] < low ? row[i] : low;
        high = row[i] > high ? row[i] : high;
    }
    return {low, high};
}

class FloorCpu final : public FloorMapper {
  public:
    explicit FloorCpu(const FloorSettings& settings) : settings_(settings) { validate(settings); }

    std::string_view backend() const override { return "cpu"; }

    void compute(const Surface& surface, FloorMap& map) override {
        const FloorFrame frame = prepare(settings_, surface);
        if (map.irradiance.nx() != frame.map_width || map.irradiance.ny() != frame.map_height)
            map.irradiance = Field<float>(frame.map_width, frame.map_height);
        map.window = frame.window;
        land(frame, surface, map.ledger);
        map.ledger.floor_w = frame.pixel_area_m2 * collector_.collect(frame, landed_, map.irradiance);
    }

  private:
    /// The ledger of row j but for the floor. Far from the map's edges, where a row's light stays in the window, there
    /// is nothing to look for.
    RowLedger account(const FloorFrame& frame, int j, RowScratch& scratch) {
        const int count = frame.columns.count, half_x = frame.half_samples(), half_y = frame.half_channels();
        const float *x = landed_.x.row(j), *y = landed_.y.row(j), *power = landed_.power.row(j);
        const auto [left, right] = range_of(x, count);
        const auto [low, high] = range_of(y, count);
        landed_.lowest[j] = low;
        landed_.highest[j] = high;
        const float base = static_cast<float>(frame.rows.first + j);
        const bool plain = left >= -half_x && right <= half_x && low >= -half_y && high <= half_y && base + low >= 0 &&
                           base + high <= static_cast<float>(frame.map_height - 1);
        const int first = std::clamp(half_x + 1 - frame.columns.first, 0, count);
        const int last = std::clamp(frame.map_width - half_x - 1 - frame.columns.first, first, count);
        const Span inner = plain ? Span{first, last} : Span{0, 0};
        RowLedger row;
        for (const Span outer : {Span{0, inner.begin}, Span{inner.end, count}}) {
            share_span(frame, j, outer, scratch, x, y);
            sum_outer(scratch, power, outer, row);
        }
        sum_inner(scratch, power, inner, row);
        return row;
    }

    /// Pass 0, with the ledger of everything but the floor.
    void land(const FloorFrame& frame, const Surface& surface, FloorLedger& ledger) {
        landed_.resize(frame.columns.count, frame.rows.count);
        std::vector<RowLedger> rows(frame.rows.count);
        const SurfaceRows reader(frame, surface);
#pragma omp parallel
        {
            RowScratch scratch(reader, frame.columns.count);
#pragma omp for schedule(static)
            for (int j = 0; j < frame.rows.count; ++j) {
                float *x = landed_.x.row(j), *y = landed_.y.row(j), *power = landed_.power.row(j);
                reader.read(j, scratch.surface, scratch.samples);
                land_row(frame, scratch, x, y, power);
                rows[j] = account(frame, j, scratch);
            }
        }
        ledger = {};
        for (const RowLedger& row : rows) {
            ledger.incident_w += frame.pixel_area_m2 * row.incident;
            ledger.reflected_w += frame.pixel_area_m2 * row.reflected;
            ledger.extinguished_w += frame.pixel_area_m2 * row.extinguished;
            ledger.outside_w += frame.pixel_area_m2 * row.outside;
            ledger.lost_w += frame.pixel_area_m2 * row.lost;
            ledger.entered_w += frame.pixel_area_m2 * row.entered;
        }
    }

    FloorSettings settings_;
    LandedSamples landed_;
    FloorCollector collector_;
};

}  // namespace

std::unique_ptr<FloorMapper> make_floor_cpu(const FloorSettings& settings) {
    return std::make_unique<FloorCpu>(settings);
}

}  // namespace waterlight
