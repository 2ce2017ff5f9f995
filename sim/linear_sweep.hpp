// Several leapfrog steps of the linear model in one pass over memory.
//
// A step is too little arithmetic for its memory traffic, so up to `depth` steps run as one wavefront: while the first
// step kicks row p, the next one works two rows behind it, and so on, all on rows that are still in the core's cache.
// (Time skewing: Wonnacott 2000, "Using time skewing to eliminate idle time due to memory bandwidth and network
// limitations".) Each thread sweeps its own band of rows in place; of the rows on both sides it keeps private copies,
// which it steps again as far as its own rows need them. Every cell goes through the same operations whichever thread
// does it and however many steps a pass takes, so that results do not depend on either, bit for bit.
#pragma once

#include <span>
#include <vector>

#include "sim/linear_rows.hpp"

namespace waterlight {

/// Where a step may differ from cell to cell: decay = x[i] * y[j] in the sponges, 1 in the domain.
template <class Real>
struct LinearDecay {
    std::vector<Real> x;  ///< one for each column
    std::vector<Real> y;  ///< one for each row
    int margin_x = 0;     ///< columns of sponge before and after the domain
};

/// A vertical inflow (m/s) over the cells, columns [begin, end) of each row; multiplied by a signal that varies in
/// time.
template <class Real>
struct LinearInflow {
    PaddedRows<Real> shape;
    std::vector<int> begin;
    std::vector<int> end;
};

/// One step, in the words of sim/kernels/linear.glsl.
template <class Real>
struct LinearStep {
    Real dt = 0;
    Real wx = 0;
    Real wy = 0;
    const LinearDecay<Real>* decay = nullptr;
    std::vector<Real> signals;  ///< one for each inflow
};

template <class Real>
class LinearSweep {
  public:
    /// For states of nx by ny cells, swept in at most `bands` bands at once.
    LinearSweep(int nx, int ny, Boundary boundary, int bands);

    /// The most steps that one pass takes.
    int depth() const { return depth_; }

    /// Takes 1 <= steps.size() <= depth() steps of the elevation (m) and its rate (m/s), both nx by ny. The ghosts of
    /// the elevation must be set, and are set afterwards.
    void run(PaddedRows<Real>& elevation, PaddedRows<Real>& rate, std::span<const LinearStep<Real>> steps,
             std::span<const LinearInflow<Real>> inflows);

  private:
    struct Band;
    struct Rows;

    void copy_halo(const Band& band, const PaddedRows<Real>& elevation, const PaddedRows<Real>& rate);
    Rows rows_of(const Band& band, PaddedRows<Real>& elevation, PaddedRows<Real>& rate);
    void sweep(const Band& band, const Rows& rows, std::span<const LinearStep<Real>> steps,
               std::span<const LinearInflow<Real>> inflows);
    Band band(int b, int steps) const;

    int nx_;
    int ny_;
    Boundary boundary_;
    int depth_;
    int bands_;
    PaddedRows<Real> halo_elevation_;  // of each band: depth rows below it, then depth rows above it
    PaddedRows<Real> halo_rate_;
    PaddedRows<Real> still_;
};

extern template class LinearSweep<float>;
extern template class LinearSweep<double>;

}  // namespace waterlight
