#include "sim/fft_plane.hpp"

#include <omp.h>

#include <algorithm>
#include <cassert>

namespace waterlight {

namespace {

/// Rows a power of two apart would share few sets of the cache: one line more spreads them.
int padded_pitch(int n) { return (n + tile_lines - 1) / tile_lines * tile_lines + tile_lines; }

}  // namespace

PlaneTransform::PlaneTransform(const AxisBasis& x, const AxisBasis& y)
    : x_(x),
      y_(y),
      pitch_(padded_pitch(x.n)),
      x_value_(x, false),
      x_slope_(x, true),
      y_value_(y, false),
      y_slope_(y, true),
      row_(x.n, 1),
      columns_(y.n, tile_lines / 2) {}

void PlaneTransform::prepare_scratch() {
    const auto threads = static_cast<std::size_t>(omp_get_max_threads());
    const int length = std::max(tile_lines * y_.n, 4 * pitch_);
    while (scratch_.size() < threads) scratch_.emplace_back(length, 1);
}

float* PlaneTransform::scratch_of_thread() { return scratch_[static_cast<std::size_t>(omp_get_thread_num())].data(); }

void PlaneTransform::columns_to_space(const Field<float>& from, bool derivative, Field<float>& to) {
    assert(from.nx() == pitch_ && to.nx() == pitch_ && from.ny() == y_.n && to.ny() == y_.n);
    prepare_scratch();
    const LinePacking& packing = derivative ? y_slope_ : y_value_;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < x_.n; i += tile_lines) {
        const int width = std::min(tile_lines, x_.n - i);
        float* tile = scratch_of_thread();
        pack_columns(packing, from.data() + i, pitch_, width, tile);
        columns_.to_space(tile);
        unpack_columns(packing, tile, to.data() + i, pitch_, width);
    }
}

void PlaneTransform::rows_to_space(const Field<float>& from, bool derivative, const PlaneWindow& window,
                                   Field<float>& to) {
    assert(from.nx() == pitch_ && window.j0 + window.ny <= y_.n && window.i0 + window.nx <= x_.n);
    prepare_scratch();
    const LinePacking& packing = derivative ? x_slope_ : x_value_;
#pragma omp parallel for schedule(static)
    for (int j = 0; j < window.ny; j += 2) {
        float* line = scratch_of_thread();
        float* a = line + 2 * pitch_;
        float* b = a + pitch_;
        const bool pair = j + 1 < window.ny;
        const float* row = from.row(window.j0 + j);
        pack_rows(packing, row, pair ? from.row(window.j0 + j + 1) : row, line);
        row_.to_space(line);
        unpack_rows(packing, line, a, b);
        std::copy_n(a + window.i0, window.nx, to.row(j));
        if (pair) std::copy_n(b + window.i0, window.nx, to.row(j + 1));
    }
}

void PlaneTransform::to_slots(Field<float>& plane) {
    assert(plane.nx() == pitch_ && plane.ny() == y_.n);
    prepare_scratch();
#pragma omp parallel for schedule(static)
    for (int j = 0; j < y_.n; j += 2) {
        float* line = scratch_of_thread();
        float* a = plane.row(j);
        float* b = j + 1 < y_.n ? plane.row(j + 1) : line + 2 * pitch_;
        if (j + 1 == y_.n) std::copy_n(a, x_.n, b);
        pack_samples(x_value_, a, b, line);
        row_.to_slots(line);
        unpack_slots(x_value_, line, a, b);
    }
#pragma omp parallel for schedule(static)
    for (int i = 0; i < x_.n; i += tile_lines) {
        const int width = std::min(tile_lines, x_.n - i);
        float* tile = scratch_of_thread();
        pack_column_samples(y_value_, plane.data() + i, pitch_, width, tile);
        columns_.to_slots(tile);
        unpack_column_slots(y_value_, tile, plane.data() + i, pitch_, width);
    }
}

}  // namespace waterlight
