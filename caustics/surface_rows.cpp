#include "caustics/surface_rows.hpp"

#include <algorithm>

#include "caustics/kernels/surface_lookup.hpp"

namespace waterlight {

namespace {

f32::AxisPlace place_x(const FloorFrame& frame, const Surface& s, SplitPlace at) {
    return f32::place_on_axis(at.whole, at.part, s.grid.nx, side_number(s.boundary.x), frame.half_width_x);
}

f32::AxisPlace place_y(const FloorFrame& frame, const Surface& s, SplitPlace at) {
    return f32::place_on_axis(at.whole, at.part, s.grid.ny, side_number(s.boundary.y), frame.half_width_y);
}

}  // namespace

SurfaceRows::SurfaceRows(const FloorFrame& frame, const Surface& surface)
    : frame_(frame),
      surface_(surface),
      climb_(surface.tilt * glm::dvec2{surface.grid.width_m(), surface.grid.height_m()}) {
    if (!frame.aligned) return;
    const Side side = surface.boundary.x;
    const int nx = surface.grid.nx;
    for (int i = 0; i < frame.columns.count; ++i) {
        const f32::AxisPlace p = place_x(frame, surface, frame.column_x[i]);
        // A blended row holds the ghost of cell -1 first; cells nx + 1 and nx + 2 behind the other ghost are still
        // water.
        const int low = side == Side::periodic ? p.low : std::clamp(frame.column_x[i].whole, -1, nx - 1);
        cell_.push_back(p.water == 0 ? nx + 2 : low + 1);
        weight_.push_back(p.weight);
        climb_x_.push_back(p.wraps_low * climb_.x);
        lit_x_.push_back(f32::lit_part(p, side_number(side)));
        counted_x_.push_back(
            f32::counted_part(p, side_number(side), frame.count_base_x, frame.columns.first + i, frame.map_width));
    }
}

SurfaceRows::Scratch SurfaceRows::scratch() const {
    const auto row = [this] {
        const std::size_t count = frame_.columns.count;
        return CellRow{-1, std::vector<float>(count), std::vector<float>(count), std::vector<float>(count)};
    };
    return {row(), row(), std::vector<float>(static_cast<std::size_t>(surface_.grid.nx) + 4)};
}

void SurfaceRows::read(int j, Scratch& scratch, SampleRow& out) const {
    if (frame_.aligned) {
        read_aligned(j, scratch, out);
    } else {
        read_turned(j, out);
    }
}

namespace {

/// Copies a row of cells and adds its ghosts; `sign` is that of a wall's mirror, `climb` that of one period.
void add_ghosts(const float* cells, int nx, Side side, float sign, float climb, std::vector<float>& row) {
    std::copy_n(cells, nx, row.begin() + 1);
    if (side == Side::periodic) {
        row[0] = row[nx] - climb;
        row[nx + 1] = row[1] + climb;
    } else {
        const float mirrored = side == Side::wall ? sign : 1.0F;
        row[0] = mirrored * row[1];
        row[nx + 1] = mirrored * row[nx];
    }
    row[nx + 2] = row[nx + 3] = 0;
}

/// to[i] = low_part low[i] + high_part high[i] + rise.
void blend(const std::vector<float>& low, float low_part, const std::vector<float>& high, float high_part, float rise,
           std::vector<float>& to) {
    const float* __restrict a = low.data();
    const float* __restrict b = high.data();
    float* __restrict out = to.data();
    const int count = static_cast<int>(to.size());
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) out[i] = low_part * a[i] + high_part * b[i] + rise;
}

void gather(const std::vector<int>& cells, const std::vector<float>& weights, const std::vector<float>& row,
            std::vector<float>& out) {
    const int* __restrict cell = cells.data();
    const float* __restrict weight = weights.data();
    const float* __restrict from = row.data();
    float* __restrict to = out.data();
    const int count = static_cast<int>(cells.size());
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const float low = from[cell[i]], high = from[cell[i] + 1];
        to[i] = low + weight[i] * (high - low);
    }
}

}  // namespace

void SurfaceRows::read_cells(int row, CellRow& out, std::vector<float>& with_ghosts) const {
    const Surface& s = surface_;
    const auto read_field = [&](const Field<float>& field, float sign, float climb, std::vector<float>& to) {
        add_ghosts(field.row(row), s.grid.nx, s.boundary.x, sign, climb, with_ghosts);
        gather(cell_, weight_, with_ghosts, to);
    };
    read_field(s.elevation, 1, climb_.x, out.elevation);
    read_field(s.slope_x, -1, 0, out.slope_x);
    read_field(s.slope_y, 1, 0, out.slope_y);
    for (std::size_t i = 0; i < climb_x_.size(); ++i) out.elevation[i] += climb_x_[i];
    out.row = row;
}

void SurfaceRows::read_aligned(int j, Scratch& scratch, SampleRow& out) const {
    const f32::AxisPlace p = place_y(frame_, surface_, frame_.row_y[j]);
    if (scratch.low.row != p.low) std::swap(scratch.low, scratch.high);
    if (scratch.low.row != p.low) read_cells(p.low, scratch.low, scratch.with_ghosts);
    if (scratch.high.row != p.high) read_cells(p.high, scratch.high, scratch.with_ghosts);

    const CellRow &low = scratch.low, &high = scratch.high;
    const float low_part = p.water * (1 - p.weight), high_part = p.water * p.weight;
    blend(low.elevation, low_part, high.elevation, high_part, climb_.y * f32::wraps_between(p), out.elevation);
    blend(low.slope_x, low_part, high.slope_x, high_part, 0, out.slope_x);
    blend(low.slope_y, low_part * p.mirror_low, high.slope_y, high_part * p.mirror_high, 0, out.slope_y);

    read_lit(j, out.lit);
    read_counted(j, out.counted);
}

void SurfaceRows::read_lit(int j, std::vector<float>& lit) const {
    const int side_x = side_number(surface_.boundary.x), side_y = side_number(surface_.boundary.y);
    if (frame_.aligned)
        return blend(lit_x_, f32::lit_part(place_y(frame_, surface_, frame_.row_y[j]), side_y), lit_x_, 0, 0, lit);
    for (int i = 0; i < frame_.columns.count; ++i)
        lit[i] = f32::lit_part(place_x(frame_, surface_, frame_.column_x[i] + frame_.row_x[j]), side_x) *
                 f32::lit_part(place_y(frame_, surface_, frame_.column_y[i] + frame_.row_y[j]), side_y);
}

void SurfaceRows::read_counted(int j, std::vector<float>& counted) const {
    const int side_x = side_number(surface_.boundary.x), side_y = side_number(surface_.boundary.y);
    const auto along_y = [&](const f32::AxisPlace& p) {
        return f32::counted_part(p, side_y, frame_.count_base_y, frame_.rows.first + j, frame_.map_height);
    };
    if (frame_.aligned)
        return blend(counted_x_, along_y(place_y(frame_, surface_, frame_.row_y[j])), counted_x_, 0, 0, counted);
    for (int i = 0; i < frame_.columns.count; ++i) {
        const f32::AxisPlace px = place_x(frame_, surface_, frame_.column_x[i] + frame_.row_x[j]);
        const f32::AxisPlace py = place_y(frame_, surface_, frame_.column_y[i] + frame_.row_y[j]);
        counted[i] = f32::counted_part(px, side_x, frame_.count_base_x, frame_.columns.first + i, frame_.map_width) *
                     along_y(py);
    }
}

void SurfaceRows::read_turned(int j, SampleRow& out) const {
    const Surface& s = surface_;
    for (int i = 0; i < frame_.columns.count; ++i) {
        const f32::AxisPlace px = place_x(frame_, s, frame_.column_x[i] + frame_.row_x[j]);
        const f32::AxisPlace py = place_y(frame_, s, frame_.column_y[i] + frame_.row_y[j]);
        const float water = px.water * py.water;
        const auto between = [&](const Field<float>& f) {
            return water * f32::bilinear(f(px.low, py.low), f(px.high, py.low), f(px.low, py.high), f(px.high, py.high),
                                         px.weight, py.weight);
        };
        const auto mirrored = [&](const Field<float>& f, float x_low, float x_high, float y_low, float y_high) {
            return water * f32::bilinear(x_low * y_low * f(px.low, py.low), x_high * y_low * f(px.high, py.low),
                                         x_low * y_high * f(px.low, py.high), x_high * y_high * f(px.high, py.high),
                                         px.weight, py.weight);
        };
        const float climb_x = climb_.x * f32::wraps_between(px);
        const float climb_y = climb_.y * f32::wraps_between(py);
        out.elevation[i] = between(s.elevation) + climb_x + climb_y;
        out.slope_x[i] = mirrored(s.slope_x, px.mirror_low, px.mirror_high, 1, 1);
        out.slope_y[i] = mirrored(s.slope_y, 1, 1, py.mirror_low, py.mirror_high);
    }
    read_lit(j, out.lit);
    read_counted(j, out.counted);
}

}  // namespace waterlight
