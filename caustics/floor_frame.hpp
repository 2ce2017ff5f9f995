// What both back-ends of the floor map share: which samples are followed, where they lie on the surface, in what units.
#pragma once

#include <vector>

#include "caustics/floor.hpp"
#include "caustics/kernels/floor.hpp"

namespace waterlight {

/// A coordinate in cells from the centre of cell 0, split so that single precision keeps it exact: whole + part.
struct SplitPlace {
    int whole = 0;
    float part = 0;  ///< in [0, 1)
};

/// Samples first .. first + count - 1 along one axis of the map; sample i belongs to base pixel i.
struct SampleRange {
    int first = 0;
    int count = 0;
};

/// One map of one surface. Sample (i, j) of the lattice (counted from 0) has base pixel (columns.first + i,
/// rows.first + j); its place along the domain's x is column_x[i] + row_x[j], along y column_y[i] + row_y[j].
struct FloorFrame {
    int map_width = 1;
    int map_height = 1;
    FloorWindow window;
    bool adaptive = true;  ///< the footprint
    int strips = 1;        ///< that a parallelogram is cut into
    SampleRange columns;
    SampleRange rows;
    std::vector<SplitPlace> column_x, row_x, column_y, row_y;
    float half_width_x = 0.5F;  ///< half of a sample's extent along the domain's x, in cells
    float half_width_y = 0.5F;
    bool aligned = true;        ///< the map's axes are the domain's: row_x and column_y are zero
    bool count_base_x = false;  ///< the ledger counts samples by their base column being on the map (periodic sides)
    bool count_base_y = false;
    float extinction_per_m = 0;
    f32::FloorLight light;
    double pixel_area_m2 = 1;

    int half_samples() const { return (window.samples - 1) / 2; }
    int half_channels() const { return (window.channels - 1) / 2; }
};

/// What the frame's window lets through to its map.
inline f32::FloorReach floor_reach(const FloorFrame& f) {
    return {.half_window = glm::vec2(f.half_samples(), f.half_channels()),
            .size = glm::vec2(f.map_width, f.map_height),
            .strips = static_cast<float>(f.strips)};
}

/// Sum of two split places.
inline SplitPlace operator+(SplitPlace a, SplitPlace b) {
    const float part = a.part + b.part;
    return part >= 1 ? SplitPlace{a.whole + b.whole + 1, part - 1} : SplitPlace{a.whole + b.whole, part};
}

/// Throws InputError where a setting is out of its range.
void validate(const FloorSettings& settings);

/// Chooses the window if it is free and lays out the samples. Throws InputError where the window asks for more samples
/// than an index can count.
FloorFrame prepare(const FloorSettings& settings, const Surface& surface);

/// The frame whose samples are the corners of those of `frame`, one more along each axis: corner (i, j) is the lower
/// left of sample (i, j).
FloorFrame corners_of(const FloorFrame& frame, const FloorSettings& settings, const Surface& surface);

/// Where light enters that hits this place of the map (pixels) if the water is at rest.
glm::dvec2 entry_m(const FloorFrame& frame, const FloorSettings& settings, glm::dvec2 pixel);

/// The least window that holds the light of every cell of the surface, with its footprint; of the adaptive one it goes
/// by a bound. `frame` has its light, footprint and strips.
FloorWindow auto_window(const FloorFrame& frame, const FloorSettings& settings, const Surface& surface);

}  // namespace waterlight
