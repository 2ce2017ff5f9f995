#include "sim/linear_sweep.hpp"

#include <algorithm>
#include <cassert>

#include "sim/kernels/linear.hpp"

namespace waterlight {

namespace {

// Half of a core's second-level cache of 512 KiB and up, and the deepest front that still gains from it.
constexpr int cache_bytes = 384 * 1024;
constexpr int deepest = 8;

using f32::leapfrog_drift;
using f32::leapfrog_kick;
using f32::sponge_kick;
using f64::leapfrog_drift;
using f64::leapfrog_kick;
using f64::sponge_kick;

// The rows that a kick of one row reads.
template <class Real>
struct Stencil {
    const Real* centre;
    const Real* south;
    const Real* north;
};

template <class Real>
void kick_row(Real* __restrict rate, const Stencil<Real>& at, int from, int to, Real wx, Real wy) {
    const Real* __restrict c = at.centre;
    const Real* __restrict s = at.south;
    const Real* __restrict n = at.north;
#pragma GCC ivdep
    for (int i = from; i < to; ++i) rate[i] += leapfrog_kick(c[i], c[i - 1], c[i + 1], s[i], n[i], wx, wy);
}

// decay_x[i] * decay_y is the decay of cell i.
template <class Real>
void kick_row_in_sponge(Real* __restrict rate, const Stencil<Real>& at, int from, int to, const LinearStep<Real>& step,
                        const Real* __restrict decay_x, Real decay_y) {
    const Real wx = step.wx;
    const Real wy = step.wy;
    const Real* __restrict c = at.centre;
    const Real* __restrict s = at.south;
    const Real* __restrict n = at.north;
#pragma GCC ivdep
    for (int i = from; i < to; ++i) {
        const Real kick = leapfrog_kick(c[i], c[i - 1], c[i + 1], s[i], n[i], wx, wy);
        rate[i] = sponge_kick(rate[i], kick, decay_x[i] * decay_y);
    }
}

template <class Real>
void kick(Real* rate, const Stencil<Real>& at, int nx, int j, const LinearStep<Real>& step) {
    const LinearDecay<Real>& decay = *step.decay;
    const int margin = decay.margin_x;
    const Real decay_y = decay.y[static_cast<std::size_t>(j)];
    const Real* decay_x = decay.x.data();
    if (decay_y < 1) {
        kick_row_in_sponge(rate, at, 0, nx, step, decay_x, decay_y);
        return;
    }
    if (margin > 0) kick_row_in_sponge(rate, at, 0, margin, step, decay_x, decay_y);
    kick_row(rate, at, margin, nx - margin, step.wx, step.wy);
    if (margin > 0) kick_row_in_sponge(rate, at, nx - margin, nx, step, decay_x, decay_y);
}

template <class Real>
void drift_row(Real* __restrict elevation, const Real* __restrict rate, int nx, Real dt) {
#pragma GCC ivdep
    for (int i = 0; i < nx; ++i) elevation[i] = leapfrog_drift(elevation[i], rate[i], dt);
}

template <class Real>
void add_inflow(Real* __restrict elevation, const LinearInflow<Real>& inflow, int j, Real amount) {
    const Real* __restrict shape = inflow.shape.row(j);
    const int begin = inflow.begin[static_cast<std::size_t>(j)];
    const int end = inflow.end[static_cast<std::size_t>(j)];
#pragma GCC ivdep
    for (int i = begin; i < end; ++i) elevation[i] += amount * shape[i];
}

int wrapped(int j, int ny) { return (j % ny + ny) % ny; }

}  // namespace

// Rows [first, last) belong to a thread; [low, high) are those that it knows at the start of a pass. They may lie
// outside the state where it is periodic.
template <class Real>
struct LinearSweep<Real>::Band {
    int index;
    int first, last;
    int low, high;
    bool closed_south, closed_north;  // the state ends at low, at high
};

template <class Real>
struct LinearSweep<Real>::Rows {
    int low;
    std::vector<Real*> elevation;  // of row low, low + 1, ...
    std::vector<Real*> rate;
    Real* elevation_of(int j) const { return elevation[static_cast<std::size_t>(j - low)]; }
    Real* rate_of(int j) const { return rate[static_cast<std::size_t>(j - low)]; }
};

template <class Real>
LinearSweep<Real>::LinearSweep(int nx, int ny, Boundary boundary, int bands)
    : nx_(nx), ny_(ny), boundary_(boundary), still_(nx, 1) {
    // A front of d steps keeps 2 d + 3 rows of both fields in use.
    const int row_bytes = 2 * still_.stride() * static_cast<int>(sizeof(Real));
    depth_ = std::clamp((cache_bytes / row_bytes - 3) / 2, 1, deepest);
    bands_ = std::clamp(bands, 1, std::max(1, ny / (2 * depth_)));
    halo_elevation_ = PaddedRows<Real>(nx, bands_ * 2 * depth_);
    halo_rate_ = PaddedRows<Real>(nx, bands_ * 2 * depth_);
}

template <class Real>
typename LinearSweep<Real>::Band LinearSweep<Real>::band(int b, int steps) const {
    const auto start = [&](int n) { return static_cast<int>(static_cast<long long>(ny_) * n / bands_); };
    Band band{b, start(b), start(b + 1), 0, 0, false, false};
    band.low = band.first - steps;
    band.high = band.last + steps;
    if (boundary_.y != Side::periodic) {
        band.closed_south = band.low <= 0;
        band.closed_north = band.high >= ny_;
        band.low = std::max(band.low, 0);
        band.high = std::min(band.high, ny_);
    }
    return band;
}

template <class Real>
void LinearSweep<Real>::copy_halo(const Band& band, const PaddedRows<Real>& elevation, const PaddedRows<Real>& rate) {
    const int south = band.index * 2 * depth_;
    const auto copy = [&](int slot, int j) {
        halo_elevation_.copy_row(slot, elevation, wrapped(j, ny_));
        halo_rate_.copy_row(slot, rate, wrapped(j, ny_));
    };
    for (int j = band.low; j < band.first; ++j) copy(south + j - band.low, j);
    for (int j = band.last; j < band.high; ++j) copy(south + depth_ + j - band.last, j);
}

template <class Real>
typename LinearSweep<Real>::Rows LinearSweep<Real>::rows_of(const Band& band, PaddedRows<Real>& elevation,
                                                            PaddedRows<Real>& rate) {
    const int south = band.index * 2 * depth_;
    Rows rows{band.low, {}, {}};
    const auto add = [&](PaddedRows<Real>& e, PaddedRows<Real>& r, int j) {
        rows.elevation.push_back(e.row(j));
        rows.rate.push_back(r.row(j));
    };
    for (int j = band.low; j < band.first; ++j) add(halo_elevation_, halo_rate_, south + j - band.low);
    for (int j = band.first; j < band.last; ++j) add(elevation, rate, j);
    for (int j = band.last; j < band.high; ++j) add(halo_elevation_, halo_rate_, south + depth_ + j - band.last);
    return rows;
}

template <class Real>
void LinearSweep<Real>::sweep(const Band& band, const Rows& rows, std::span<const LinearStep<Real>> steps,
                              std::span<const LinearInflow<Real>> inflows) {
    const auto stencil = [&](int j) {
        // Beyond a wall the row's own mirror, beyond an absorbing side still water.
        const auto beyond = [&] { return boundary_.y == Side::wall ? rows.elevation_of(j) : still_.row(0); };
        return Stencil<Real>{rows.elevation_of(j), j == band.low ? beyond() : rows.elevation_of(j - 1),
                             j == band.high - 1 ? beyond() : rows.elevation_of(j + 1)};
    };
    const int count = static_cast<int>(steps.size());
    for (int front = band.low; front < band.high + 2 * count - 1; ++front) {
        for (int s = 0; s < count; ++s) {
            // The rows that step s can still know: one less at each open end than the step before it.
            const int begin = band.closed_south ? band.low : band.low + s + 1;
            const int end = band.closed_north ? band.high : band.high - s - 1;
            const LinearStep<Real>& step = steps[static_cast<std::size_t>(s)];
            const int kicked = front - 2 * s;
            if (kicked >= begin && kicked < end) {
                kick(rows.rate_of(kicked), stencil(kicked), nx_, wrapped(kicked, ny_), step);
            }
            // A row may move once the kicks of both its neighbours have read it.
            const int moved = kicked - 1;
            if (moved >= begin && moved < end) {
                Real* elevation = rows.elevation_of(moved);
                drift_row(elevation, rows.rate_of(moved), nx_, step.dt);
                for (std::size_t n = 0; n < inflows.size(); ++n) {
                    add_inflow(elevation, inflows[n], wrapped(moved, ny_), step.dt * step.signals[n]);
                }
                set_ghosts(elevation, nx_, boundary_.x);
            }
        }
    }
}

template <class Real>
void LinearSweep<Real>::run(PaddedRows<Real>& elevation, PaddedRows<Real>& rate,
                            std::span<const LinearStep<Real>> steps, std::span<const LinearInflow<Real>> inflows) {
    assert(elevation.nx() == nx_ && elevation.ny() == ny_ && rate.nx() == nx_ && rate.ny() == ny_);
    const int count = static_cast<int>(steps.size());
    assert(count >= 1 && count <= depth_);
    // All copies are taken before any row changes.
#pragma omp parallel for schedule(static)
    for (int b = 0; b < bands_; ++b) copy_halo(band(b, count), elevation, rate);
#pragma omp parallel for schedule(static)
    for (int b = 0; b < bands_; ++b) {
        const Band mine = band(b, count);
        sweep(mine, rows_of(mine, elevation, rate), steps, inflows);
    }
}

template class LinearSweep<float>;
template class LinearSweep<double>;

}  // namespace waterlight
