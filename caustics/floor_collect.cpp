#include "caustics/floor_collect.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace waterlight {

void LandedSamples::resize(int nx, int ny) {
    if (x.nx() == nx && x.ny() == ny) return;
    x = Field<float>(nx, ny);
    y = Field<float>(nx, ny);
    power = Field<float>(nx, ny);
    lowest.assign(ny, 0);
    highest.assign(ny, 0);
}

namespace {

/// Pass 1 for one row of samples. Four floats at once, which neither the loop nor the SLP vectoriser sees.
void add_shares(int count, const int* __restrict pixel, const float* __restrict shares, float* __restrict channels) {
    using Four = float __attribute__((vector_size(16)));
    for (int i = 0; i < count; ++i) {
        float* to = channels + 4 * static_cast<std::ptrdiff_t>(pixel[i]);
        Four sum, add;
        std::memcpy(&sum, to, sizeof sum);
        std::memcpy(&add, shares + 4 * static_cast<std::ptrdiff_t>(i), sizeof add);
        sum += add;
        std::memcpy(to, &sum, sizeof sum);
    }
}

/// Pass 2 for one row of pixels: `own` and `below` are the channels from column -1 on of the row and of the one below.
double sum_channels(int width, const float* __restrict own, const float* __restrict below, float* __restrict map) {
#pragma GCC ivdep
    for (int i = 0; i < width; ++i) map[i] = (own[4 * i + 4] + own[4 * i + 1]) + (below[4 * i + 6] + below[4 * i + 3]);
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (int i = 0; i < width; ++i) sum += map[i];
    return sum;
}

/// For each row of samples, the lowest row of pixels that it or any later row touches.
std::vector<int> lowest_rows_to_come(const FloorFrame& frame, const LandedSamples& landed) {
    std::vector<int> lowest(frame.rows.count + 1, frame.map_height);
    const float half = static_cast<float>(frame.half_channels());
    for (int j = frame.rows.count - 1; j >= 0; --j) {
        const float least = std::floor(std::clamp(landed.lowest[j], -half - 2, half + 1));
        lowest[j] = std::min(lowest[j + 1], frame.rows.first + j + static_cast<int>(least));
    }
    return lowest;
}

}  // namespace

/// Rows [begin, end) of the map. Their channels, and those of row begin - 1 whose boxes reach into them, live in a ring
/// of rows: a row is summed and its place cleared for a later one as soon as no sample to come can touch it.
class FloorCollector::Band {
  public:
    Band(const FloorFrame& frame, Scratch& scratch, int begin, int end)
        : frame_(frame), s_(scratch), end_(end), oldest_(begin - 1) {
        ring_ = std::min(frame.window.channels + 5, end - begin + 1);
        const std::size_t count = frame.columns.count;
        s_.pixel.resize(count);
        s_.shares.resize(4 * count);
        s_.channels.assign(4 * (static_cast<std::size_t>(ring_) * columns() + 1), 0.0F);
    }

    /// Pass 1 for row j of the samples.
    void add(const LandedSamples& landed, int j) {
        share_out(landed, j, s_.pixel.data(), s_.shares.data());
        add_shares(frame_.columns.count, s_.pixel.data(), s_.shares.data(), s_.channels.data());
    }

    /// Pass 2 for all rows below `row` that are not summed yet.
    void sum_below(int row, Field<float>& map, std::vector<double>& row_sums) {
        while (oldest_ + 1 < std::min(row, end_)) {
            const int next = oldest_ + 1;
            row_sums[next] = sum_channels(frame_.map_width, channels(next), channels(oldest_), map.row(next));
            std::fill_n(channels(oldest_), 4 * static_cast<std::size_t>(columns()), 0.0F);
            ++oldest_;
            oldest_slot_ = oldest_slot_ + 1 == ring_ ? 0 : oldest_slot_ + 1;
        }
    }

  private:
    int columns() const { return frame_.map_width + 1; }  // from column -1 on

    float* channels(int row) {
        const int slot = (oldest_slot_ + row - oldest_) % ring_;
        return s_.channels.data() + 4 * static_cast<std::size_t>(slot) * columns();
    }

    /// For each sample of row j: the lower left pixel of its box, and the shares of the four pixels, none beyond the
    /// window. What touches no pixel of the band goes to a pixel behind the ring.
    void share_out(const LandedSamples& landed, int j, int* __restrict pixel, float* __restrict shares) const {
        const float* __restrict x = landed.x.row(j);
        const float* __restrict y = landed.y.row(j);
        const float* __restrict power = landed.power.row(j);
        const float half_x = static_cast<float>(frame_.half_samples());
        const float half_y = static_cast<float>(frame_.half_channels());
        const int first_column = frame_.columns.first + 1, row_from_oldest = frame_.rows.first + j - oldest_;
        const int rows = std::min(ring_, end_ - oldest_), width = columns(), nowhere = ring_ * width;
        const int ring = ring_, oldest_slot = oldest_slot_, count = frame_.columns.count;
#pragma GCC ivdep
        for (int i = 0; i < count; ++i) {
            // Clamped so that any number, also one that is not, has an integer part.
            const float low_x = f32::floor(f32::clamp(x[i], -half_x - 2, half_x + 1));
            const float low_y = f32::floor(f32::clamp(y[i], -half_y - 2, half_y + 1));
            const f32::BoxShare share_x = f32::box_share(x[i], low_x, half_x);
            const f32::BoxShare share_y = f32::box_share(y[i], low_y, half_y);
            const int column = first_column + i + static_cast<int>(low_x);
            const int row = row_from_oldest + static_cast<int>(low_y);
            const bool inside = (column >= 0) & (column < width) & (row >= 0) & (row < rows);
            const int slot = oldest_slot + row >= ring ? oldest_slot + row - ring : oldest_slot + row;
            pixel[i] = inside ? slot * width + column : nowhere;
            const float bottom = power[i] * share_y.low, top = power[i] * share_y.high;
            shares[4 * i] = bottom * share_x.low;
            shares[4 * i + 1] = bottom * share_x.high;
            shares[4 * i + 2] = top * share_x.low;
            shares[4 * i + 3] = top * share_x.high;
        }
    }

    const FloorFrame& frame_;
    Scratch& s_;
    int end_;
    int oldest_;  ///< row whose channels are the oldest in the ring
    int oldest_slot_ = 0;
    int ring_ = 1;  ///< rows in the ring
};

double FloorCollector::collect(const FloorFrame& frame, const LandedSamples& landed, Field<float>& map) {
    std::vector<double> row_sums(frame.map_height);
    const std::vector<int> to_come = lowest_rows_to_come(frame, landed);
    scratch_.resize(omp_get_max_threads());
#pragma omp parallel
    {
        const std::int64_t height = frame.map_height;
        const int threads = omp_get_num_threads(), me = omp_get_thread_num();
        const int begin = static_cast<int>(height * me / threads), end = static_cast<int>(height * (me + 1) / threads);
        Band band(frame, scratch_[me], begin, end);
        band.sum_below(to_come[0], map, row_sums);
        for (int j = 0; j < frame.rows.count; ++j) {
            const float base = static_cast<float>(frame.rows.first + j);
            const bool apart = base + landed.highest[j] + 1 < static_cast<float>(begin) ||
                               base + landed.lowest[j] - 1 > static_cast<float>(end);
            if (!apart) band.add(landed, j);
            band.sum_below(to_come[j + 1], map, row_sums);
        }
        band.sum_below(end, map, row_sums);
    }
    double sum = 0;
    for (const double row : row_sums) sum += row;
    return sum;
}

}  // namespace waterlight
