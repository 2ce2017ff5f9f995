#include "caustics/floor_parallelograms.hpp"

namespace waterlight {

namespace {

// What a sample's neighbours on both sides overlap it by, relative to its area, where their parallelograms are taken
// for boxes: slant times slide.
constexpr float unnoticed = 2e-4F;

/// Landed rows around one: the differences between neighbours are half of the next's less half of the last's, at the
/// lattice's edges one-sided.
struct Neighbours {
    const float *x, *y, *x_below, *y_below, *x_above, *y_above;
    float per_row;

    Neighbours(const LandedSamples& landed, int j, int rows)
        : x(landed.x.row(j)),
          y(landed.y.row(j)),
          x_below(landed.x.row(std::max(j - 1, 0))),
          y_below(landed.y.row(std::max(j - 1, 0))),
          x_above(landed.x.row(std::min(j + 1, rows - 1))),
          y_above(landed.y.row(std::min(j + 1, rows - 1))),
          per_row(j > 0 && j + 1 < rows ? 0.5F : 1.0F) {}

    f32::Parallelogram at(int i, int left, int right, float per_column) const {
        return f32::landed_parallelogram(
            {1 + per_column * (x[right] - x[left]), per_column * (y[right] - y[left])},
            {per_row * (x_above[i] - x_below[i]), 1 + per_row * (y_above[i] - y_below[i])});
    }
};

}  // namespace

ParallelogramShaper::ParallelogramShaper(const FloorFrame& frame, const SurfaceRows& surface)
    : frame_(frame), surface_(surface), counted_(frame.columns.count), shares_(frame.columns.count) {
    for (std::vector<float>* row :
         {&row_.width, &row_.height, &row_.slant, &row_.slide, &half_x_, &half_y_, &span_, &shear_})
        row->resize(frame.columns.count);
}

const ParallelogramRow& ParallelogramShaper::shape(const LandedSamples& landed, int j) {
    const int count = frame_.columns.count;
    const Neighbours around(landed, j, frame_.rows.count);
    const float strips = static_cast<float>(frame_.strips);
    float* __restrict width = row_.width.data();
    float* __restrict height = row_.height.data();
    float* __restrict slant = row_.slant.data();
    float* __restrict slide = row_.slide.data();
    float* __restrict half_x = half_x_.data();
    float* __restrict half_y = half_y_.data();
    float* __restrict span = span_.data();
    float* __restrict shear = shear_.data();
    const auto put = [&](int i, const f32::Parallelogram& p) {
        width[i] = p.width;
        height[i] = p.height;
        slant[i] = p.slant;
        slide[i] = p.slide;
        const f32::real2 half = f32::half_extent(p, strips);
        half_x[i] = half.x;
        half_y[i] = half.y;
        span[i] = f32::abs(p.width) / strips + f32::abs(p.slant);
        shear[i] = f32::abs(p.slant * p.slide);
    };
#pragma GCC ivdep
    for (int i = 1; i < count - 1; ++i) put(i, around.at(i, i - 1, i + 1, 0.5F));
    if (count > 0) put(0, around.at(0, 0, std::min(1, count - 1), 1));
    if (count > 1) put(count - 1, around.at(count - 1, count - 2, count - 1, 1));
    measure(landed, j);
    return row_;
}

void ParallelogramShaper::measure(const LandedSamples& landed, int j) {
    const int count = frame_.columns.count;
    row_.tallest = range_of(row_.height.data(), count).second;
    row_.widest = range_of(span_.data(), count).second;
    row_.upright = range_of(shear_.data(), count).second < unnoticed;
    if (row_.upright) {
        std::ranges::fill(row_.slant, 0.0F);
        std::ranges::fill(row_.slide, 0.0F);
        row_.widest = 2 * range_of(half_x_.data(), count).second;
    }
    const auto [left, right] = range_of(landed.x.row(j), count);
    const auto [low, high] = range_of(landed.y.row(j), count);
    const float most_x = range_of(half_x_.data(), count).second, most_y = range_of(half_y_.data(), count).second;
    const float window_x = static_cast<float>(frame_.half_samples()) + 0.5F - most_x;
    const float window_y = static_cast<float>(frame_.half_channels()) + 0.5F - most_y;
    row_.clipped = !(left >= -window_x && right <= window_x && low >= -window_y && high <= window_y);
    const float base = static_cast<float>(frame_.rows.first + j) + 0.5F;
    row_.on_rows = base + low - most_y >= 0 && base + high + most_y <= static_cast<float>(frame_.map_height);
}

void ParallelogramShaper::account(const LandedSamples& landed, int j, RowLedger& ledger) {
    const Span inner = !row_.clipped && row_.on_rows ? inner_columns(frame_) : Span{0, 0};
    surface_.read_counted(j, counted_);
    for (const Span outer : {Span{0, inner.begin}, Span{inner.end, frame_.columns.count}}) {
        share_span(landed, j, outer);
        sum_outer(counted_.data(), landed.power.row(j), shares_, outer, ledger);
    }
}

void ParallelogramShaper::share_span(const LandedSamples& landed, int j, Span span) {
    const float* __restrict x = landed.x.row(j);
    const float* __restrict y = landed.y.row(j);
    const float* __restrict width = row_.width.data();
    const float* __restrict height = row_.height.data();
    const float* __restrict slant = row_.slant.data();
    const float* __restrict slide = row_.slide.data();
    float* __restrict in_window = shares_.in_window.data();
    float* __restrict on_map = shares_.on_map.data();
    const f32::FloorReach reach = floor_reach(frame_);
    const float first = static_cast<float>(frame_.columns.first), base_y = static_cast<float>(frame_.rows.first + j);
    for (int i = span.begin; i < span.end; ++i) in_window[i] = on_map[i] = 0;
    for (float strip = 0; strip < reach.strips; ++strip) {
#pragma GCC ivdep
        for (int i = span.begin; i < span.end; ++i) {
            const f32::Parallelogram p{width[i], height[i], slant[i], slide[i]};
            const f32::SampleShare share = f32::share_of(reach, f32::strip_of(p, {x[i], y[i]}, strip, reach.strips),
                                                         {first + static_cast<float>(i), base_y});
            in_window[i] += share.in_window;
            on_map[i] += share.on_map;
        }
    }
}

void widen(const FloorFrame& frame, LandedSamples& landed) {
    const std::vector<float> lowest = landed.lowest, highest = landed.highest;
    const int rows = frame.rows.count;
    for (int j = 0; j < rows; ++j) {
        const int below = std::max(j - 1, 0), above = std::min(j + 1, rows - 1);
        const float apart = std::max(highest[above] - lowest[below], highest[below] - lowest[above]);
        const float within = highest[j] - lowest[j];
        // Both a.y and b.y are at most this; the strips of d climb no more than c does.
        const float height = 1 + std::max(apart, within);
        const float more = 0.5F * (frame.strips > 1 ? 2 * height : height) - 0.5F;
        landed.lowest[j] -= more;
        landed.highest[j] += more;
    }
}

}  // namespace waterlight
