#include "caustics/floor_collect.hpp"

#include <omp.h>

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

/// Rows [begin, end) of the map. Pixels are counted from column -1 of row begin - 1, whose boxes reach into the band;
/// one more takes what belongs nowhere.
struct BandShape {
    int begin, end, width;
    int stride() const { return width + 1; }
    int pixels() const { return (end - begin + 1) * stride(); }
};

/// For each sample of row j: the lower left pixel of its box, and the shares of the four pixels, none beyond the
/// window.
void share_out(const FloorFrame& frame, const LandedSamples& landed, int j, const BandShape& band,
               int* __restrict pixel, float* __restrict shares) {
    const float* __restrict x = landed.x.row(j);
    const float* __restrict y = landed.y.row(j);
    const float* __restrict power = landed.power.row(j);
    const float half_x = static_cast<float>(frame.half_samples()), half_y = static_cast<float>(frame.half_channels());
    const int first_column = frame.columns.first, row_from_band = frame.rows.first + j - (band.begin - 1);
    const int rows = band.end - band.begin + 1, columns = band.stride(), nowhere = band.pixels();
    const int count = frame.columns.count;
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const float low_x = f32::floor(f32::clamp(x[i], -half_x - 2, half_x + 1));
        const float low_y = f32::floor(f32::clamp(y[i], -half_y - 2, half_y + 1));
        const f32::BoxShare share_x = f32::box_share(x[i], low_x, half_x),
                            share_y = f32::box_share(y[i], low_y, half_y);
        const int column = first_column + i + static_cast<int>(low_x) + 1;
        const int row = row_from_band + static_cast<int>(low_y);
        const bool inside = (column >= 0) & (column < columns) & (row >= 0) & (row < rows);
        pixel[i] = inside ? row * columns + column : nowhere;
        const float bottom = power[i] * share_y.low, top = power[i] * share_y.high;
        shares[4 * i] = bottom * share_x.low;
        shares[4 * i + 1] = bottom * share_x.high;
        shares[4 * i + 2] = top * share_x.low;
        shares[4 * i + 3] = top * share_x.high;
    }
}

/// Pass 1 for one row of samples. Four floats at once, as neither loop nor SLP vectoriser sees them.
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

/// Pass 2 for one row of pixels; `above` and `below` point at the channels of its column -1 in its own row and in the
/// one below.
double sum_channels(int width, const float* __restrict own, const float* __restrict below, float* __restrict map) {
#pragma GCC ivdep
    for (int i = 0; i < width; ++i) map[i] = (own[4 * i + 4] + own[4 * i + 1]) + (below[4 * i + 6] + below[4 * i + 3]);
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (int i = 0; i < width; ++i) sum += map[i];
    return sum;
}

}  // namespace

double FloorCollector::collect(const FloorFrame& frame, const LandedSamples& landed, Field<float>& map) {
    std::vector<double> row_sums(frame.map_height);
    bands_.resize(omp_get_max_threads());
#pragma omp parallel
    {
        const std::int64_t height = frame.map_height;
        const int threads = omp_get_num_threads(), me = omp_get_thread_num(), count = frame.columns.count;
        const BandShape shape{static_cast<int>(height * me / threads), static_cast<int>(height * (me + 1) / threads),
                              frame.map_width};
        Band& band = bands_[me];
        band.pixel.resize(count);
        band.shares.resize(4 * static_cast<std::size_t>(count));
        band.channels.assign(4 * (static_cast<std::size_t>(shape.pixels()) + 1), 0.0F);
        for (int j = 0; j < frame.rows.count; ++j) {
            const float base = static_cast<float>(frame.rows.first + j);
            const bool apart = base + landed.highest[j] + 1 < static_cast<float>(shape.begin) ||
                               base + landed.lowest[j] - 1 > static_cast<float>(shape.end);
            if (apart) continue;
            share_out(frame, landed, j, shape, band.pixel.data(), band.shares.data());
            add_shares(count, band.pixel.data(), band.shares.data(), band.channels.data());
        }
        for (int j = shape.begin; j < shape.end; ++j) {
            const std::size_t row = 4 * static_cast<std::size_t>(shape.stride());
            const float* below = band.channels.data() + (j - shape.begin) * row;
            row_sums[j] = sum_channels(shape.width, below + row, below, map.row(j));
        }
    }
    double sum = 0;
    for (const double row : row_sums) sum += row;
    return sum;
}

}  // namespace waterlight
