// The floor map's ledger on the CPU, row by row.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "caustics/floor_collect.hpp"
#include "caustics/object_shadows.hpp"

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

/// Powers of a row of samples, W/m2 of surface, and the part of each that the ledger counts.
struct SampleRowPowers {
    const float *counted, *incident, *transmitted, *arrived;
};

/// Adds samples to the ledger as if all their light fell on the map.
inline void sum_row(const SampleRowPowers& p, int count, RowLedger& row) {
    double in = 0, reflected = 0, extinguished = 0, entered = 0;
#pragma omp simd reduction(+ : in, reflected, extinguished, entered)
    for (int i = 0; i < count; ++i) {
        in += p.counted[i] * p.incident[i];
        reflected += p.counted[i] * (p.incident[i] - p.transmitted[i]);
        extinguished += p.counted[i] * (p.transmitted[i] - p.arrived[i]);
        entered += (1 - p.counted[i]) * p.arrived[i];
    }
    row.incident += in;
    row.reflected += reflected;
    row.extinguished += extinguished;
    row.entered += entered;
}

/// Takes from a sample what objects stop of it, of the ledger as sum_row() filled it.
inline void shade_sample(const f64::SampleShadow& shadow, double counted, double incident, double transmitted,
                         double arrived, RowLedger& row) {
    const f64::ShadedLight light = f64::shade(shadow, incident, transmitted, arrived);
    row.reflected += counted * (light.reflected - (incident - transmitted));
    row.extinguished += counted * (light.extinguished - (transmitted - arrived));
    row.objects += counted * light.objects;
    row.entered += (1 - counted) * (light.arrived - arrived);
}

/// The same for the samples of a row, and takes it from what arrives.
inline void shade_row(std::span<const ShadowedSample> shadows, const SampleRowPowers& p, float* arrived,
                      RowLedger& row) {
    for (const ShadowedSample& s : shadows) {
        const int i = s.column;
        shade_sample(s.shadow, p.counted[i], p.incident[i], p.transmitted[i], arrived[i], row);
        arrived[i] = static_cast<float>(f64::shade(s.shadow, 0, 0, arrived[i]).arrived);
    }
}

/// All rows, of samples of this area; without what landed on the map.
inline FloorLedger total(const std::vector<RowLedger>& rows, double area_m2) {
    FloorLedger sum;
    for (const RowLedger& row : rows) {
        sum.incident_w += area_m2 * row.incident;
        sum.reflected_w += area_m2 * row.reflected;
        sum.extinguished_w += area_m2 * row.extinguished;
        sum.outside_w += area_m2 * row.outside;
        sum.lost_w += area_m2 * row.lost;
        sum.objects_w += area_m2 * row.objects;
        sum.entered_w += area_m2 * row.entered;
    }
    return sum;
}

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
