// Where the two-pass floor map on the CPU holds what pass 1 made and pass 2 has not summed yet.
#pragma once

#include <omp.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "caustics/floor_collect.hpp"

namespace waterlight {

/// A ring of rows of pixels with four channels each: a row's place is cleared for a later one as soon as no sample to
/// come can touch it.
class ChannelRing {
  public:
    /// `storage` must outlive the ring.
    ChannelRing(std::vector<float>& storage, int columns, int rows, int oldest)
        : storage_(storage), columns_(columns), rows_(rows), oldest_(oldest) {
        storage_.assign(4 * (static_cast<std::size_t>(rows) * columns + 1), 0.0F);
    }

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    int oldest() const { return oldest_; }
    float* row(int row) {
        return storage_.data() + 4 * static_cast<std::size_t>((oldest_slot_ + row - oldest_) % rows_) * columns_;
    }
    /// The pixel behind the ring, to which goes what touches no pixel of it.
    int nowhere() const { return rows_ * columns_; }

    /// Number of a pixel in the ring, `row` counted from the oldest, or nowhere(). `rows` is rows() or less.
    int pixel(int column, int row, int rows) const {
        const bool inside = (column >= 0) & (column < columns_) & (row >= 0) & (row < rows);
        const int slot = oldest_slot_ + row >= rows_ ? oldest_slot_ + row - rows_ : oldest_slot_ + row;
        return inside ? slot * columns_ + column : nowhere();
    }

    void clear_oldest() {
        std::fill_n(row(oldest_), 4 * static_cast<std::size_t>(columns_), 0.0F);
        ++oldest_;
        oldest_slot_ = oldest_slot_ + 1 == rows_ ? 0 : oldest_slot_ + 1;
    }

    /// Adds to a pixel's own channel.
    void add(int pixel, float light) { storage_[4 * static_cast<std::size_t>(pixel)] += light; }

    /// Adds the four shares of each sample to the channels of its pixel. Four floats at once, which neither the loop
    /// nor the SLP vectoriser sees.
    void add(int count, const int* __restrict pixel, const float* __restrict shares) {
        using Four = float __attribute__((vector_size(16)));
        float* __restrict channels = storage_.data();
        for (int i = 0; i < count; ++i) {
            float* to = channels + 4 * static_cast<std::ptrdiff_t>(pixel[i]);
            Four sum, more;
            std::memcpy(&sum, to, sizeof sum);
            std::memcpy(&more, shares + 4 * static_cast<std::ptrdiff_t>(i), sizeof more);
            sum += more;
            std::memcpy(to, &sum, sizeof sum);
        }
    }

  private:
    std::vector<float>& storage_;
    int columns_;
    int rows_;
    int oldest_;
    int oldest_slot_ = 0;
};

/// Rows [begin, end) of the map, as one thread sums them. A pixel's channels are the light of itself, of the one to its
/// right, of the one above and of that one's right. The ring holds also those of row begin - 1, which reach into them.
class ChannelBand {
  public:
    ChannelBand(const FloorFrame& frame, std::vector<float>& storage, int begin, int end)
        : frame_(frame),
          begin_(begin),
          end_(end),
          ring_(storage, frame.map_width + 1, std::min(frame.window.channels + 5, end - begin + 1), begin - 1) {}

    /// Pass 2 for all rows below `row` that are not summed yet.
    void sum_below(int row, Field<float>& map, std::vector<double>& row_sums);

  protected:
    /// Rows of the ring that belong to the band, and its first column's number less that of the map.
    int rows() const { return std::min(ring_.rows(), end_ - ring_.oldest()); }
    static constexpr int lead = 1;

    const FloorFrame& frame_;
    int begin_;
    int end_;
    ChannelRing ring_;
};

/// For each row of samples, the lowest row of pixels that it or any later row touches.
std::vector<int> lowest_rows_to_come(const FloorFrame& frame, const LandedSamples& landed);

/// Passes 1 and 2 of all rows: each thread takes a band [begin, end) of the map's rows, make_band(thread, begin, end),
/// adds to it the samples that may touch it and sums what no later one touches. Returns the sum over the map.
template <class MakeBand>
double collect_in_bands(const FloorFrame& frame, const LandedSamples& landed, Field<float>& map,
                        const MakeBand& make_band) {
    std::vector<double> row_sums(frame.map_height);
    const std::vector<int> to_come = lowest_rows_to_come(frame, landed);
#pragma omp parallel
    {
        const std::int64_t height = frame.map_height;
        const int threads = omp_get_num_threads(), me = omp_get_thread_num();
        const int begin = static_cast<int>(height * me / threads), end = static_cast<int>(height * (me + 1) / threads);
        auto band = make_band(me, begin, end);
        band.sum_below(to_come[0], map, row_sums);
        for (int j = 0; j < frame.rows.count; ++j) {
            const float base = static_cast<float>(frame.rows.first + j);
            const bool apart = base + landed.highest[j] + 1 < static_cast<float>(begin) ||
                               base + landed.lowest[j] - 1 > static_cast<float>(end);
            band.add(landed, j, apart);
            band.sum_below(to_come[j + 1], map, row_sums);
        }
        band.sum_below(end, map, row_sums);
    }
    double sum = 0;
    for (const double row : row_sums) sum += row;
    return sum;
}

}  // namespace waterlight
