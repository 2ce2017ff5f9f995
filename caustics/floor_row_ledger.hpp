// The floor map's ledger on the CPU, row by row.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "caustics/floor_collect.hpp"

namespace waterlight {

/// Samples [begin, end) of a row.
struct Span {
    int begin = 0;
    int end = 0;
};

/// Scratch of one row: how much of each sample's footprint the window sees and, of that, how much lies on the map.
struct Shares {
    std::vector<float> in_window, on_map;
    explicit Shares(int count) : in_window(count), on_map(count) {}
};

/// Base pixels whose samples fall on the map from side to side wherever in the window they land.
inline Span inner_columns(const FloorFrame& frame) {
    const int count = frame.columns.count, half = frame.half_samples();
    const int first = std::clamp(half + 1 - frame.columns.first, 0, count);
    return {first, std::clamp(frame.map_width - half - 1 - frame.columns.first, first, count)};
}

/// Takes from `row`, which counts all light as on the map, what does not land there.
inline void sum_outer(const float* counted, const float* power, const Shares& shares, Span span, RowLedger& row) {
    const float* in_window = shares.in_window.data();
    const float* on_map = shares.on_map.data();
    double outside = 0, lost = 0, not_entered = 0;
#pragma omp simd reduction(+ : outside, lost, not_entered)
    for (int i = span.begin; i < span.end; ++i) {
        lost += counted[i] * power[i] * (1 - in_window[i]);
        outside += counted[i] * power[i] * (in_window[i] - on_map[i]);
        not_entered += (1 - counted[i]) * power[i] * (1 - on_map[i]);
    }
    row.lost += lost;
    row.outside += outside;
    row.entered -= not_entered;
}

/// Least and largest of a row, and 0; a NaN is passed over.
inline std::pair<float, float> range_of(const float* row, int count) {
    float low = 0, high = 0;
#pragma omp simd reduction(min : low) reduction(max : high)
    for (int i = 0; i < count; ++i) {
        low = row[i] < low ? row[i] : low;
        high = row[i] > high ? row[i] : high;
    }
    return {low, high};
}

}  // namespace waterlight
