#include "caustics/floor_collect.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>

#include "caustics/floor_ring.hpp"

namespace waterlight {

void LandedSamples::resize(const FloorFrame& frame) {
    const int nx = frame.columns.count, ny = frame.rows.count;
    const auto fit = [&](Field<float>& f) {
        if (f.nx() != nx || f.ny() != ny) f = Field<float>(nx, ny);
    };
    for (Field<float>* f : {&x, &y, &power}) fit(*f);
    lowest.assign(ny, 0);
    highest.assign(ny, 0);
}

namespace {

/// Pass 2 for one row of pixels: `own` and `below` are the channels from column -1 on of the row and of the one below.
double sum_channels(int width, const float* __restrict own, const float* __restrict below, float* __restrict map) {
#pragma GCC ivdep
    for (int i = 0; i < width; ++i) map[i] = (own[4 * i + 4] + own[4 * i + 1]) + (below[4 * i + 6] + below[4 * i + 3]);
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (int i = 0; i < width; ++i) sum += map[i];
    return sum;
}

}  // namespace

std::vector<int> lowest_rows_to_come(const FloorFrame& frame, const LandedSamples& landed) {
    std::vector<int> lowest(frame.rows.count + 1, frame.map_height);
    const float half = static_cast<float>(frame.half_channels());
    for (int j = frame.rows.count - 1; j >= 0; --j) {
        const float least = std::floor(std::clamp(landed.lowest[j], -half - 2, half + 1));
        lowest[j] = std::min(lowest[j + 1], frame.rows.first + j + static_cast<int>(least));
    }
    return lowest;
}

void ChannelBand::sum_below(int row, Field<float>& map, std::vector<double>& row_sums) {
    while (ring_.oldest() + 1 < std::min(row, end_)) {
        const int next = ring_.oldest() + 1;
        row_sums[next] = sum_channels(frame_.map_width, ring_.row(next), ring_.row(next - 1), map.row(next));
        ring_.clear_oldest();
    }
}

class FloorCollector::Band : public ChannelBand {
  public:
    Band(const FloorFrame& frame, Scratch& scratch, int begin, int end)
        : ChannelBand(frame, scratch.channels, begin, end), s_(scratch) {
        const std::size_t count = frame.columns.count;
        s_.pixel.resize(count);
        s_.shares.resize(4 * count);
    }

    /// Pass 1 for row j of the samples; `apart`: none of it can touch the band.
    void add(const LandedSamples& landed, int j, bool apart) {
        if (apart) return;
        share_out(landed, j, s_.pixel.data(), s_.shares.data());
        ring_.add(frame_.columns.count, s_.pixel.data(), s_.shares.data());
    }

  private:
    /// For each sample of row j: the lower left pixel of its box, and the shares of the four pixels, none beyond the
    /// window. What touches no pixel of the band goes to a pixel behind the ring.
    void share_out(const LandedSamples& landed, int j, int* __restrict pixel, float* __restrict shares) const {
        const float* __restrict x = landed.x.row(j);
        const float* __restrict y = landed.y.row(j);
        const float* __restrict power = landed.power.row(j);
        const float half_x = static_cast<float>(frame_.half_samples());
        const float half_y = static_cast<float>(frame_.half_channels());
        const ChannelRing ring = ring_;
        const int first_column = frame_.columns.first + lead, row_from_oldest = frame_.rows.first + j - ring.oldest();
        const int rows = this->rows(), count = frame_.columns.count;
#pragma GCC ivdep
        for (int i = 0; i < count; ++i) {
            // Clamped so that any number, also one that is not, has an integer part.
            const float low_x = f32::floor(f32::clamp(x[i], -half_x - 2, half_x + 1));
            const float low_y = f32::floor(f32::clamp(y[i], -half_y - 2, half_y + 1));
            const f32::BoxShare share_x = f32::box_share(x[i], low_x, half_x);
            const f32::BoxShare share_y = f32::box_share(y[i], low_y, half_y);
            const int column = first_column + i + static_cast<int>(low_x);
            const int row = row_from_oldest + static_cast<int>(low_y);
            pixel[i] = ring.pixel(column, row, rows);
            const float bottom = power[i] * share_y.low, top = power[i] * share_y.high;
            shares[4 * i] = bottom * share_x.low;
            shares[4 * i + 1] = bottom * share_x.high;
            shares[4 * i + 2] = top * share_x.low;
            shares[4 * i + 3] = top * share_x.high;
        }
    }

    Scratch& s_;
};

double FloorCollector::collect(const FloorFrame& frame, const LandedSamples& landed, Field<float>& map) {
    scratch_.resize(omp_get_max_threads());
    return collect_in_bands(frame, landed, map,
                            [&](int thread, int begin, int end) { return Band(frame, scratch_[thread], begin, end); });
}

}  // namespace waterlight
