// The state of the shallow-water model: fields with a frame of two cells for what lies beyond the sides.
#pragma once

#include "sim/field.hpp"

namespace waterlight {

/// nx by ny values and two more on every side; rows are aligned for SIMD.
template <class Real>
class FramedRows {
  public:
    static constexpr int frame = 2;

    FramedRows() = default;
    FramedRows(int nx, int ny) : nx_(nx), ny_(ny), storage_(stride_for(nx), ny + 2 * frame) {}

    int nx() const { return nx_; }
    int ny() const { return ny_; }

    /// The first value of row j, -2 <= j < ny + 2; [-2] to [nx + 1] are there.
    Real* row(int j) { return storage_.row(j + frame) + lead; }
    const Real* row(int j) const { return storage_.row(j + frame) + lead; }

    /// All of it, the frame and what pads the rows included.
    std::span<Real> values() { return storage_.values(); }

    static int stride_for(int nx) { return (nx + 15) / 16 * 16 + 2 * lead; }
    static constexpr int lead = 16;  // values before a row: keeps row(j) on a 64-byte line

  private:
    int nx_ = 0;
    int ny_ = 0;
    Field<Real> storage_;
};

/// What changes: how far the surface has moved from where it started, and the discharge. Kept apart from the initial
/// surface and depth, small changes survive in single precision under any depth and on ground of any height.
template <class Real>
struct ShallowFields {
    FramedRows<Real> rise;  ///< m
    FramedRows<Real> qx;    ///< m2/s
    FramedRows<Real> qy;    ///< m2/s

    ShallowFields() = default;
    ShallowFields(int nx, int ny) : rise(nx, ny), qx(nx, ny), qy(nx, ny) {}
};

/// What stays: the surface (m above the datum) and the depth (m) at the start. Surface = initial surface + rise, depth
/// = initial depth + rise, height of the ground = initial surface - initial depth.
template <class Real>
struct ShallowStart {
    FramedRows<Real> surface;
    FramedRows<Real> depth;
    /// Above level 0, m. Near the water, so that single precision holds a lake on a mountain as well as the sea.
    double datum_m = 0;

    ShallowStart() = default;
    ShallowStart(int nx, int ny) : surface(nx, ny), depth(nx, ny) {}
};

}  // namespace waterlight
