#include "sim/shallow_sweep.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "sim/kernels/shallow_water.hpp"

namespace waterlight {

namespace {

// A band of rows is worth a thread from so many on, and the scheme reaches no further than to the next band.
constexpr int least_rows = 4;

// Rows of scratch memory that come round: row r lies where row r - N lay.
template <class Row, int N>
struct Ring {
    std::array<Row, N> rows;
    Row& at(int r) { return rows[static_cast<std::size_t>((r + 8 * N) % N)]; }
};

// Water of a row of cells.
template <class Real>
struct CellRow {
    Real *e, *h, *u, *v, *z;
};

// Water at one side of the faces of a row; u across, v along the face.
template <class Real>
struct FaceRow {
    Real *e, *h, *u, *v;
};

template <class Real>
struct FluxRow {
    Real *mass, *along, *push_low, *push_high;
};

template <class Real>
struct Kernels;
template <>
struct Kernels<float> {
    using FaceWater = f32::FaceWater;
    using FaceSteps = f32::FaceSteps;
    using FaceFlux = f32::FaceFlux;
};
template <>
struct Kernels<double> {
    using FaceWater = f64::FaceWater;
    using FaceSteps = f64::FaceSteps;
    using FaceFlux = f64::FaceFlux;
};

using f32::crossing_rate;
using f32::drain_part;
using f32::face_depth;
using f32::flow_per_discharge;
using f32::friction_part;
using f32::ground_step;
using f32::limited_steps;
using f32::shallow_flux;
using f32::slope_freedom;
using f32::surface_force;
using f64::crossing_rate;
using f64::drain_part;
using f64::face_depth;
using f64::flow_per_discharge;
using f64::friction_part;
using f64::ground_step;
using f64::limited_steps;
using f64::shallow_flux;
using f64::slope_freedom;
using f64::surface_force;

// Surface, depth, velocity and ground of cells -2 to nx + 1 of a row.
template <class Real>
void find_water(const ShallowStart<Real>& start, const ShallowFields<Real>& from, int row, Real film,
                const CellRow<Real>& to) {
    const Real* __restrict surface = start.surface.row(row);
    const Real* __restrict depth = start.depth.row(row);
    const Real* __restrict rise = from.rise.row(row);
    const Real* __restrict qx = from.qx.row(row);
    const Real* __restrict qy = from.qy.row(row);
    Real* __restrict e = to.e;
    Real* __restrict h = to.h;
    Real* __restrict u = to.u;
    Real* __restrict v = to.v;
    Real* __restrict z = to.z;
    const int nx = start.depth.nx();
#pragma GCC ivdep
    for (int i = -2; i < nx + 2; ++i) {
        const Real deep = depth[i] + rise[i];
        const Real flow = flow_per_discharge(deep, film);
        e[i] = surface[i] + rise[i];
        h[i] = deep;
        u[i] = qx[i] * flow;
        v[i] = qy[i] * flow;
        z[i] = surface[i] - depth[i];
    }
}

// Water at both faces of cells [from, to) along one axis, and the force of the surface between them. `before` and
// `after` are the neighbours along the axis: the rows beside, or the same row shifted.
template <class Real>
void find_faces(const CellRow<Real>& before, const CellRow<Real>& at, const CellRow<Real>& after, int from, int to,
                Real gravity, const FaceRow<Real>& low, const FaceRow<Real>& high, Real* __restrict force) {
    const Real *e0 = before.e, *h0 = before.h, *u0 = before.u, *v0 = before.v, *z0 = before.z;
    const Real *e = at.e, *h = at.h, *u = at.u, *v = at.v, *z = at.z;
    const Real *e1 = after.e, *h1 = after.h, *u1 = after.u, *v1 = after.v, *z1 = after.z;
    Real* __restrict le = low.e, * __restrict lh = low.h, * __restrict lu = low.u, * __restrict lv = low.v;
    Real* __restrict he = high.e, * __restrict hh = high.h, * __restrict hu = high.u, * __restrict hv = high.v;
    using Steps = typename Kernels<Real>::FaceSteps;
#pragma GCC ivdep
    for (int i = from; i < to; ++i) {
        const Real freedom = slope_freedom(h0[i], h[i], h1[i], z0[i], z[i], z1[i]);
        const Real ground = ground_step(z[i] - z0[i], z1[i] - z[i]);
        const Steps rise = limited_steps(e[i] - e0[i], e1[i] - e[i], freedom);
        const Steps across = limited_steps(u[i] - u0[i], u1[i] - u[i], freedom);
        const Steps along = limited_steps(v[i] - v0[i], v1[i] - v[i], freedom);
        const Real e_low = e[i] + rise.low;
        const Real e_high = e[i] + rise.high;
        const Real h_low = face_depth(e_low, z[i] - ground, h[i]);
        const Real h_high = face_depth(e_high, z[i] + ground, h[i]);
        le[i] = e_low;
        he[i] = e_high;
        lh[i] = h_low;
        hh[i] = h_high;
        lu[i] = u[i] + across.low;
        hu[i] = u[i] + across.high;
        lv[i] = v[i] + along.low;
        hv[i] = v[i] + along.high;
        force[i] = surface_force(gravity, h_low, h_high, e_low, e_high);
    }
}

// Flux through faces [from, to): `low` and `high` are the water on their low and high sides.
template <class Real>
void find_flux(const FaceRow<Real>& low, const FaceRow<Real>& high, int from, int to, Real gravity,
               const FluxRow<Real>& flux) {
    const Real *le = low.e, *lh = low.h, *lu = low.u, *lv = low.v;
    const Real *he = high.e, *hh = high.h, *hu = high.u, *hv = high.v;
    Real* __restrict mass = flux.mass, * __restrict along = flux.along;
    Real* __restrict push_low = flux.push_low, * __restrict push_high = flux.push_high;
    using Water = typename Kernels<Real>::FaceWater;
#pragma GCC ivdep
    for (int i = from; i < to; ++i) {
        const auto f = shallow_flux(Water{le[i], lh[i], lu[i], lv[i]}, Water{he[i], hh[i], hu[i], hv[i]}, gravity);
        mass[i] = f.mass;
        along[i] = f.along;
        push_low[i] = f.push_low;
        push_high[i] = f.push_high;
    }
}

// Rate of change (m2/s2) of the discharge across the faces of cells [0, nx). `before` and `after` are their faces.
template <class Real>
void find_push(const Real* before_push_high, const Real* after_push_low, const Real* __restrict force, int nx,
               Real per_d, Real* __restrict push) {
#pragma GCC ivdep
    for (int i = 0; i < nx; ++i) push[i] = per_d * (before_push_high[i] - after_push_low[i] - force[i]);
}

template <class Real>
CellRow<Real> shifted(const CellRow<Real>& r, int by) {
    return {r.e + by, r.h + by, r.u + by, r.v + by, r.z + by};
}
template <class Real>
FaceRow<Real> shifted(const FaceRow<Real>& r, int by) {
    return {r.e + by, r.h + by, r.u + by, r.v + by};
}

}  // namespace

// The rows that belong to one thread, [first, last).
template <class Real>
class ShallowSweep<Real>::Band {
  public:
    Band(const ShallowSweep& sweep, const ShallowStage<Real>& stage, const ShallowStart<Real>& start,
         const ShallowFields<Real>& from, ShallowFields<Real>& to, Field<Real>& scratch)
        : s_(sweep), stage_(stage), start_(start), from_(from), to_(to) {
        int next = 0;
        const auto row = [&] { return scratch.row(next++) + FramedRows<Real>::lead; };
        const auto faces = [&] { return FaceRow<Real>{row(), row(), row(), row()}; };
        const auto flux = [&] { return FluxRow<Real>{row(), row(), row(), row()}; };
        for (CellRow<Real>& r : water_.rows) r = {row(), row(), row(), row(), row()};
        x_low_ = faces();
        x_high_ = faces();
        y_low_ = faces();
        for (FaceRow<Real>& r : y_high_.rows) r = faces();
        for (FluxRow<Real>& r : x_flux_.rows) r = flux();
        for (FluxRow<Real>& r : y_flux_.rows) r = flux();
        for (auto* ring : {&x_push_, &y_push_, &y_force_, &drain_})
            for (Real*& r : ring->rows) r = row();
        x_force_ = row();
    }

    static constexpr int scratch_rows = 15 + 12 + 8 + 12 + 12 + 12 + 1;

    ShallowPeak run(int first, int last) {
        const bool open_low = first == 0 && !s_.periodic_y_;
        const bool open_high = last == s_.ny_ && !s_.periodic_y_;
        const int lowest = open_low ? -1 : first - 2;  // row of cells with faces
        const int highest = open_high ? last : last + 1;
        find_water_of(lowest - 1);
        find_water_of(lowest);
        if (open_low) spare(-1);
        for (int r = lowest; r <= highest; ++r) {
            find_water_of(r + 1);
            find_y(r, r > lowest);
            const bool has_x = r >= (open_low ? 0 : first - 1) && r <= (open_high ? last - 1 : last);
            if (has_x) find_x(r);
            const bool has_drain = r - 1 >= (open_low ? 0 : first - 1) && r - 1 <= (open_high ? last - 1 : last);
            if (has_drain) find_drain(r - 1);
            if (r - 2 >= first) update(r - 2);
        }
        if (open_high) {
            spare(last);
            update(last - 1);
        }
        return peak_;
    }

    ShallowPeak look(int first, int last) {
        for (int r = first; r < last; ++r) calm(r);
        return peak_;
    }

  private:
    int wrapped(int r) const { return s_.periodic_y_ ? ((r % s_.ny_) + s_.ny_) % s_.ny_ : r; }

    void find_water_of(int r) { find_water(start_, from_, wrapped(r), stage_.film, water_.at(r)); }

    // Along y: faces of row r, the flux between it and the row before, and what pushes that.
    void find_y(int r, bool has_flux) {
        const auto turned = [](const CellRow<Real>& c) { return CellRow<Real>{c.e, c.h, c.v, c.u, c.z}; };
        find_faces(turned(water_.at(r - 1)), turned(water_.at(r)), turned(water_.at(r + 1)), 0, s_.nx_, stage_.gravity,
                   y_low_, y_high_.at(r), y_force_.at(r));
        if (!has_flux) return;
        find_flux(y_high_.at(r - 1), y_low_, 0, s_.nx_, stage_.gravity, y_flux_.at(r));
        find_push(y_flux_.at(r - 1).push_high, y_flux_.at(r).push_low, y_force_.at(r - 1), s_.nx_, stage_.per_dy,
                  y_push_.at(r - 1));
    }

    void find_x(int r) {
        const CellRow<Real>& at = water_.at(r);
        find_faces(shifted(at, -1), at, shifted(at, 1), -1, s_.nx_ + 1, stage_.gravity, x_low_, x_high_, x_force_);
        const FluxRow<Real>& flux = x_flux_.at(r);
        find_flux(shifted(x_high_, -1), x_low_, 0, s_.nx_ + 1, stage_.gravity, flux);
        find_push(flux.push_high, flux.push_low + 1, x_force_, s_.nx_, stage_.per_dx, x_push_.at(r));
    }

    // A row beyond the sides gives what is asked of it.
    void spare(int r) {
        std::fill_n(drain_.at(r) - 1, s_.nx_ + 2, Real(1));
        drains_.at(r) = false;
    }

    void find_drain(int r) {
        const Real* __restrict x = x_flux_.at(r).mass;
        const Real* __restrict y = y_flux_.at(r).mass;
        const Real* __restrict y1 = y_flux_.at(r + 1).mass;
        const Real* __restrict depth = start_.depth.row(wrapped(r));
        const Real* __restrict rise = from_.rise.row(wrapped(r));
        Real* __restrict drain = drain_.at(r);
        const Real per_dx = stage_.per_dx, per_dy = stage_.per_dy, dt = stage_.dt;
        const Real none = 0;
        int cuts = 0;
#pragma GCC ivdep
        for (int i = 0; i < s_.nx_; ++i) {
            const Real low_x = x[i] < none ? x[i] : none;
            const Real high_x = x[i + 1] > none ? x[i + 1] : none;
            const Real low_y = y[i] < none ? y[i] : none;
            const Real high_y = y1[i] > none ? y1[i] : none;
            drain[i] = drain_part(depth[i] + rise[i], per_dx * (high_x - low_x) + per_dy * (high_y - low_y), dt);
            cuts |= drain[i] < 1 ? 1 : 0;
        }
        drain[-1] = s_.periodic_x_ ? drain[s_.nx_ - 1] : Real(1);
        drain[s_.nx_] = s_.periodic_x_ ? drain[0] : Real(1);
        drains_.at(r) = cuts != 0;
    }

    void update(int r) {
        if (drains_.at(r - 1) || drains_.at(r) || drains_.at(r + 1))
            advance<true>(r);
        else
            advance<false>(r);
        if (!stage_.averages) return;
        if (stage_.friction > 0) rub(r);
        calm(r);
    }

    template <bool drains>
    void advance(int r) {
        const int row = r;
        const Real *x_mass = x_flux_.at(r).mass, *x_along = x_flux_.at(r).along;
        const Real *y_mass = y_flux_.at(r).mass, *y_along = y_flux_.at(r).along;
        const Real *y1_mass = y_flux_.at(r + 1).mass, *y1_along = y_flux_.at(r + 1).along;
        const Real *push_x = x_push_.at(r), *push_y = y_push_.at(r);
        const Real *drain = drain_.at(r), *drain0 = drain_.at(r - 1), *drain1 = drain_.at(r + 1);
        const Real *from_rise = from_.rise.row(row), *from_qx = from_.qx.row(row), *from_qy = from_.qy.row(row);
        const Real* depth = start_.depth.row(row);
        Real *rise = to_.rise.row(row), *qx = to_.qx.row(row), *qy = to_.qy.row(row);
        const Real dt = stage_.dt, per_dx = stage_.per_dx, per_dy = stage_.per_dy;
        const Real old = stage_.averages ? Real(0.5) : Real(0), own = Real(1) - old;
        const Real none = 0;
#pragma GCC ivdep
        for (int i = 0; i < s_.nx_; ++i) {
            Real west = x_mass[i], east = x_mass[i + 1], south = y_mass[i], north = y1_mass[i];
            Real west_v = x_along[i], east_v = x_along[i + 1], south_u = y_along[i], north_u = y1_along[i];
            if constexpr (drains) {
                const Real at_west = west > none ? drain[i - 1] : drain[i];
                const Real at_east = east > none ? drain[i] : drain[i + 1];
                const Real at_south = south > none ? drain0[i] : drain[i];
                const Real at_north = north > none ? drain[i] : drain1[i];
                west *= at_west, west_v *= at_west;
                east *= at_east, east_v *= at_east;
                south *= at_south, south_u *= at_south;
                north *= at_north, north_u *= at_north;
            }
            const Real gain = from_rise[i] + dt * (per_dx * (west - east) + per_dy * (south - north));
            const Real gain_x = from_qx[i] + dt * (push_x[i] + per_dy * (south_u - north_u));
            const Real gain_y = from_qy[i] + dt * (push_y[i] + per_dx * (west_v - east_v));
            const Real empty = -depth[i];
            const Real next = old * rise[i] + own * gain;
            rise[i] = next < empty ? empty : next;  // a NaN stays
            qx[i] = old * qx[i] + own * gain_x;
            qy[i] = old * qy[i] + own * gain_y;
        }
    }

    // The discharge of films follows their velocity. Finds the fastest waves: rates are compared as integers, which for
    // positive numbers have the same order, vectorise, and let a NaN come out on top.
    void calm(int r) {
        using Bits = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;
        const Real* __restrict depth = start_.depth.row(r);
        const Real* __restrict rise = to_.rise.row(r);
        Real* __restrict qx = to_.qx.row(r), * __restrict qy = to_.qy.row(r);
        const Real g = stage_.gravity, film = stage_.film, per_dx = stage_.per_dx, per_dy = stage_.per_dy;
        Bits most = 0;
#pragma GCC ivdep
        for (int i = 0; i < s_.nx_; ++i) {
            const Real h = depth[i] + rise[i];
            const Real flow = flow_per_discharge(h, film);
            const Real u = qx[i] * flow, v = qy[i] * flow;
            qx[i] = h < film ? h * u : qx[i];
            qy[i] = h < film ? h * v : qy[i];
            const Bits rate =
                std::bit_cast<Bits>(crossing_rate(h, u, v, g, per_dx, per_dy)) & std::numeric_limits<Bits>::max();
            most = rate > most ? rate : most;
        }
        const double rate = std::bit_cast<Real>(most);
        peak_.finite = peak_.finite && std::isfinite(rate);
        peak_.rate = std::max(peak_.rate, rate);
    }

    void rub(int r) {
        const Real* __restrict depth = start_.depth.row(r);
        const Real* __restrict rise = to_.rise.row(r);
        Real* __restrict qx = to_.qx.row(r), * __restrict qy = to_.qy.row(r);
        const Real friction = stage_.friction, film = stage_.film;
#pragma GCC ivdep
        for (int i = 0; i < s_.nx_; ++i) {
            const Real q = std::sqrt(qx[i] * qx[i] + qy[i] * qy[i]);
            const Real part = friction_part(depth[i] + rise[i], q, friction, film);
            qx[i] *= part;
            qy[i] *= part;
        }
    }

    const ShallowSweep& s_;
    const ShallowStage<Real>& stage_;
    const ShallowStart<Real>& start_;
    const ShallowFields<Real>& from_;
    ShallowFields<Real>& to_;
    Ring<CellRow<Real>, 3> water_;
    FaceRow<Real> x_low_, x_high_, y_low_;
    Ring<FaceRow<Real>, 2> y_high_;
    Ring<FluxRow<Real>, 3> x_flux_, y_flux_;
    Ring<Real*, 3> x_push_, y_push_, y_force_, drain_;
    Real* x_force_;
    Ring<bool, 3> drains_{};
    ShallowPeak peak_;
};

template <class Real>
ShallowSweep<Real>::ShallowSweep(int nx, int ny, bool periodic_x, bool periodic_y)
    : nx_(nx), ny_(ny), periodic_x_(periodic_x), periodic_y_(periodic_y) {}

template <class Real>
template <class Work>
ShallowPeak ShallowSweep<Real>::in_bands(Work work) {
    const int bands = std::clamp(omp_get_max_threads(), 1, std::max(1, ny_ / least_rows));
    while (static_cast<int>(scratch_.size()) < bands)
        scratch_.emplace_back(FramedRows<Real>::stride_for(nx_), Band::scratch_rows);
    std::vector<ShallowPeak> peaks(static_cast<std::size_t>(bands));
#pragma omp parallel for num_threads(bands) schedule(static, 1)
    for (int b = 0; b < bands; ++b) {
        const auto edge = [&](int n) { return static_cast<int>(static_cast<std::int64_t>(ny_) * n / bands); };
        peaks[static_cast<std::size_t>(b)] = work(scratch_[static_cast<std::size_t>(b)], edge(b), edge(b + 1));
    }
    ShallowPeak peak;
    for (const ShallowPeak& p : peaks) {
        peak.rate = std::max(peak.rate, p.rate);
        peak.finite = peak.finite && p.finite;
    }
    return peak;
}

template <class Real>
ShallowPeak ShallowSweep<Real>::run(const ShallowStage<Real>& stage, const ShallowStart<Real>& start,
                                    const ShallowFields<Real>& from, ShallowFields<Real>& to) {
    return in_bands([&](Field<Real>& scratch, int first, int last) {
        return Band(*this, stage, start, from, to, scratch).run(first, last);
    });
}

template <class Real>
ShallowPeak ShallowSweep<Real>::look(const ShallowStage<Real>& stage, const ShallowStart<Real>& start,
                                     ShallowFields<Real>& fields) {
    return in_bands([&](Field<Real>& scratch, int first, int last) {
        return Band(*this, stage, start, fields, fields, scratch).look(first, last);
    });
}

template class ShallowSweep<float>;
template class ShallowSweep<double>;

}  // namespace waterlight
