// The state of the linear model: rows with room for a neighbour on either side, aligned for SIMD.
#pragma once

#include <algorithm>
#include <cassert>

#include "sim/boundary.hpp"
#include "sim/field.hpp"

namespace waterlight {

/// ny rows of nx values, each with one ghost value before it and one after it.
template <class Real>
class PaddedRows {
  public:
    PaddedRows() = default;
    PaddedRows(int nx, int ny) : nx_(nx), storage_(stride_for(nx), ny) {}

    int nx() const { return nx_; }
    int ny() const { return storage_.ny(); }
    int stride() const { return storage_.nx(); }

    /// The first value of row j; [-1] and [nx] are its ghosts.
    Real* row(int j) { return storage_.row(j) + lead; }
    const Real* row(int j) const { return storage_.row(j) + lead; }

    /// All of it, ghosts and what pads the rows included.
    std::span<Real> values() { return storage_.values(); }

    /// Copies all rows of another array of this shape.
    void copy(const PaddedRows& from) {
        assert(from.stride() == stride() && from.ny() == ny());
#pragma omp parallel for schedule(static)
        for (int j = 0; j < ny(); ++j) copy_row(j, from, j);
    }

    /// Copies a row of another array of this width, ghosts included.
    void copy_row(int j, const PaddedRows& from, int from_j) {
        std::copy_n(from.storage_.row(from_j), stride(), storage_.row(j));
    }

  private:
    static constexpr int lead = 16;  // values before a row: keeps row(j) on a 64-byte line
    static int stride_for(int nx) { return (nx + 15) / 16 * 16 + 2 * lead; }

    int nx_ = 0;
    Field<Real> storage_;
};

/// Sets the ghosts of a row of nx values to what lies beyond the x sides: the mirror, the other end, or still water.
template <class Real>
void set_ghosts(Real* row, int nx, Side side) {
    row[-1] = side == Side::wall ? row[0] : side == Side::periodic ? row[nx - 1] : Real(0);
    row[nx] = side == Side::wall ? row[nx - 1] : side == Side::periodic ? row[0] : Real(0);
}

/// The row before (step = -1) or after (step = 1) row j: the mirror, the other end, or `still`.
template <class Real>
const Real* neighbour_row(const PaddedRows<Real>& rows, int j, int step, Side side, const Real* still) {
    const int to = j + step;
    if (to >= 0 && to < rows.ny()) return rows.row(to);
    if (side == Side::wall) return rows.row(j);
    return side == Side::periodic ? rows.row(to < 0 ? rows.ny() - 1 : 0) : still;
}

}  // namespace waterlight
