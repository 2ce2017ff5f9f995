// The floor map on the CPU. Yuksel & Keyser gather: each pixel of pass 1 asks N samples which of its M + 1 channels
// they hit, since a fragment shader cannot scatter. A sample's box touches two columns and two rows, so the same sums
// cost four additions a sample, whatever N and M, when pass 1 visits samples and adds straight into the rows that the
// channels stand for. Pass 0 is theirs. The order of additions to a pixel does not depend on the number of threads.
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "caustics/floor.hpp"
#include "caustics/floor_frame.hpp"
#include "caustics/surface_rows.hpp"

namespace waterlight {

namespace {

/// Landed samples of the whole lattice: displacement in pixels and power in W/m2 of surface.
struct Landed {
    Field<float> x, y, power;
    std::vector<float> reach_low, reach_high;  ///< least and largest y displacement of each row's lit samples

    void resize(int nx, int ny) {
        if (x.nx() == nx && x.ny() == ny) return;
        x = Field<float>(nx, ny);
        y = Field<float>(nx, ny);
        power = Field<float>(nx, ny);
        reach_low.resize(ny);
        reach_high.resize(ny);
    }
};

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

/// The part of each sample's box that the window sees and, of that, what lies on the map.
void share_row(const FloorFrame& frame, int j, RowScratch& scratch, const float* __restrict x,
               const float* __restrict y) {
    const int count = frame.columns.count;
    const float first = static_cast<float>(frame.columns.first), base_y = static_cast<float>(frame.rows.first + j);
    const float half_x = static_cast<float>(frame.half_samples()), half_y = static_cast<float>(frame.half_channels());
    const float width = static_cast<float>(frame.map_width), height = static_cast<float>(frame.map_height);
    float* __restrict in_window = scratch.in_window.data();
    float* __restrict on_map = scratch.on_map.data();
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const f32::AxisShare sx = f32::share_on_axis(x[i], first + static_cast<float>(i), half_x, width);
        const f32::AxisShare sy = f32::share_on_axis(y[i], base_y, half_y, height);
        in_window[i] = sx.in_window * sy.in_window;
        on_map[i] = sx.on_map * sy.on_map;
    }
}

RowLedger sum_row(const RowScratch& scratch, const float* power, int count) {
    const float* counted = scratch.samples.counted.data();
    const float* incident = scratch.incident.data();
    const float* transmitted = scratch.transmitted.data();
    const float* in_window = scratch.in_window.data();
    const float* on_map = scratch.on_map.data();
    double in = 0, reflected = 0, extinguished = 0, outside = 0, lost = 0, entered = 0;
#pragma omp simd reduction(+ : in, reflected, extinguished, outside, lost, entered)
    for (int i = 0; i < count; ++i) {
        in += counted[i] * incident[i];
        reflected += counted[i] * (incident[i] - transmitted[i]);
        extinguished += counted[i] * (transmitted[i] - power[i]);
        lost += counted[i] * power[i] * (1 - in_window[i]);
        outside += counted[i] * power[i] * (in_window[i] - on_map[i]);
        entered += (1 - counted[i]) * power[i] * on_map[i];
    }
    return {in, reflected, extinguished, outside, lost, entered};
}

/// Adds the light of row j of the lattice to rows [begin, end) of the map.
void scatter_row(const FloorFrame& frame, const Landed& landed, int j, int begin, int end, Field<float>& map) {
    const int half_x = frame.half_samples(), half_y = frame.half_channels(), width = frame.map_width;
    const float* __restrict x = landed.x.row(j);
    const float* __restrict y = landed.y.row(j);
    const float* __restrict power = landed.power.row(j);
    for (int i = 0; i < frame.columns.count; ++i) {
        // Also skips a displacement that is not a number.
        if (!(std::abs(x[i]) <= half_x + 1 && std::abs(y[i]) <= half_y + 1)) continue;
        const float low_x = std::floor(x[i]), low_y = std::floor(y[i]);
        const int step_x = static_cast<int>(low_x), step_y = static_cast<int>(low_y);
        const int column = frame.columns.first + i + step_x, row = frame.rows.first + j + step_y;
        const float right = (x[i] - low_x) * power[i], left = power[i] - right, top = y[i] - low_y, bottom = 1 - top;
        const bool take_left = step_x >= -half_x && column >= 0 && column < width;
        const bool take_right = step_x < half_x && column + 1 >= 0 && column + 1 < width;
        if (step_y >= -half_y && row >= begin && row < end) {
            float* to = map.row(row) + column;
            if (take_left) to[0] += left * bottom;
            if (take_right) to[1] += right * bottom;
        }
        if (step_y < half_y && row + 1 >= begin && row + 1 < end) {
            float* to = map.row(row + 1) + column;
            if (take_left) to[0] += left * top;
            if (take_right) to[1] += right * top;
        }
    }
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
        collect(frame, map);
    }

  private:
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
                share_row(frame, j, scratch, x, y);
                rows[j] = sum_row(scratch, power, frame.columns.count);
                const auto [low, high] = std::minmax_element(y, y + frame.columns.count);
                landed_.reach_low[j] = frame.columns.count > 0 ? *low : 0;
                landed_.reach_high[j] = frame.columns.count > 0 ? *high : 0;
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

    /// Passes 1 and 2, each thread for its own band of the map.
    void collect(const FloorFrame& frame, FloorMap& map) const {
        const int height = frame.map_height;
        std::vector<double> row_sum(height);
#pragma omp parallel
        {
            const int threads = omp_get_num_threads(), me = omp_get_thread_num();
            const int begin = static_cast<int>(std::int64_t{height} * me / threads);
            const int end = static_cast<int>(std::int64_t{height} * (me + 1) / threads);
            std::fill(map.irradiance.row(begin), map.irradiance.row(end), 0.0F);
            for (int j = 0; j < frame.rows.count; ++j) {
                const float base = static_cast<float>(frame.rows.first + j);
                const bool reaches =
                    base + landed_.reach_high[j] + 1 >= begin && base + landed_.reach_low[j] - 1 <= end;
                if (reaches) scatter_row(frame, landed_, j, begin, end, map.irradiance);
            }
            for (int j = begin; j < end; ++j) {
                double sum = 0;
                const float* row = map.irradiance.row(j);
#pragma omp simd reduction(+ : sum)
                for (int i = 0; i < frame.map_width; ++i) sum += row[i];
                row_sum[j] = sum;
            }
        }
        map.ledger.floor_w = 0;
        for (const double sum : row_sum) map.ledger.floor_w += frame.pixel_area_m2 * sum;
    }

    FloorSettings settings_;
    Landed landed_;
};

}  // namespace

std::unique_ptr<FloorMapper> make_floor_cpu(const FloorSettings& settings) {
    return std::make_unique<FloorCpu>(settings);
}

}  // namespace waterlight
