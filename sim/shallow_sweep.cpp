#include "sim/shallow_sweep.hpp"

#include <omp.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "sim/denormals.hpp"
#include "sim/kernels/shallow_water.hpp"
#include "sim/shallow_row_loops.hpp"

namespace waterlight {

namespace {

// A band of rows is worth a thread from so many on, and the scheme reaches no further than to the next band.
constexpr int least_rows = 4;

using f32::crossing_rate;
using f32::drain_part;
using f32::flow_per_discharge;
using f32::friction_part;
using f32::held_momentum;
using f32::kept_flow;
using f32::slowing_depth;
using f64::crossing_rate;
using f64::drain_part;
using f64::flow_per_discharge;
using f64::friction_part;
using f64::held_momentum;
using f64::kept_flow;
using f64::slowing_depth;

}  // namespace

using namespace row_loops;

// The rows that belong to one thread, [first, last).
template <class Real>
template <bool second>
class ShallowSweep<Real>::Band {
  public:
    using Now = std::conditional_t<second, ShallowFields<Real>, const ShallowFields<Real>>;
    using Change = std::conditional_t<second, const ShallowFields<Real>, ShallowFields<Real>>;

    Band(ShallowSweep& sweep, const ShallowStage<Real>& stage, const ShallowStart<Real>& start, Now& now,
         Change& change, Field<Real>& scratch)
        : s_(sweep), stage_(stage), start_(start), now_(now), change_(change) {
        int next = 0;
        const auto row = [&] { return scratch.row(next++) + FramedRows<Real>::lead; };
        const auto faces = [&] { return FaceRow<Real>{row(), row(), row(), row()}; };
        const auto flux = [&] { return FluxRow<Real>{row(), row(), row(), row()}; };
        for (auto* ring : {&water_, &ahead_})
            for (CellRow<Real>& r : ring->rows) r = {row(), row(), row(), row(), row()};
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

    static constexpr int scratch_rows = 25 + 25 + 12 + 8 + 12 + 12 + 12 + 1;

    /// The band [first, last). Reads what it needs of rows beyond it, which others will change.
    void prepare(int first, int last) {
        first_ = first;
        last_ = last;
        at_low_side_ = first == 0 && !s_.periodic_y_;
        at_high_side_ = last == s_.ny_ && !s_.periodic_y_;
        lowest_ = at_low_side_ ? -1 : first - 2;
        highest_ = at_high_side_ ? last : last + 1;
        for (int r = lowest_ - 1; r < first; ++r) find_water_of(r, water_.at(r));
        for (int r = last; r <= highest_ + 1; ++r) find_water_of(r, ahead_.at(r));
    }

    // A row is updated once the outflow of those beside it is known, two rows behind the one whose faces are found.
    ShallowPeak run() {
        const int first_drain = at_low_side_ ? 0 : first_ - 1, last_drain = at_high_side_ ? last_ - 1 : last_;
        if (at_low_side_) spare(-1);
        if (at_high_side_) spare(last_);
        for (int r = lowest_; r <= highest_; ++r) {
            if (r + 1 >= last_)
                std::swap(water_.at(r + 1), ahead_.at(r + 1));
            else if (r + 1 >= first_)
                find_water_of(r + 1, water_.at(r + 1));
            find_y(r, r > lowest_);
            if (r >= first_drain && r <= last_drain) find_x(r);
            if (r - 1 >= first_drain) find_drain(r - 1);
            if (r - 2 >= first_) update(r - 2);
        }
        if (at_high_side_) update(last_ - 1);
        return peak_;
    }

    ShallowPeak rub() {
        for (int r = first_; r < last_; ++r) rub(r);
        return peak_;
    }

    ShallowPeak look() {
        for (int r = first_; r < last_; ++r) calm(r);
        return peak_;
    }

  private:
    int wrapped(int r) const { return s_.periodic_y_ ? ((r % s_.ny_) + s_.ny_) % s_.ny_ : r; }

    void find_water_of(int r, const CellRow<Real>& to) {
        find_water<second>(start_, now_, change_, wrapped(r), stage_.film, to);
    }

    // Along y: faces of row r, the flux between it and the row before, and what pushes that.
    void find_y(int r, bool has_flux) {
        const auto turned = [](const CellRow<Real>& c) { return CellRow<Real>{c.e, c.h, c.v, c.u, c.z}; };
        find_faces(turned(water_.at(r - 1)), turned(water_.at(r)), turned(water_.at(r + 1)), 0, s_.nx_, stage_.gravity,
                   y_low_, y_high_.at(r), y_force_.at(r));
        if (!has_flux) return;
        find_flux(y_high_.at(r - 1), y_low_, 0, s_.nx_, stage_.gravity, y_flux_.at(r));
        if (r == 0) pass(stage_.gates.south, y_flux_.at(r), 0, s_.nx_);
        if (r == s_.ny_) pass(stage_.gates.north, y_flux_.at(r), 0, s_.nx_);
        find_push(y_flux_.at(r - 1).push_high, y_flux_.at(r).push_low, y_force_.at(r - 1), s_.nx_, stage_.per_dy,
                  y_push_.at(r - 1));
    }

    void find_x(int r) {
        const CellRow<Real>& at = water_.at(r);
        find_faces(shifted(at, -1), at, shifted(at, 1), -1, s_.nx_ + 1, stage_.gravity, x_low_, x_high_, x_force_);
        const FluxRow<Real>& flux = x_flux_.at(r);
        find_flux(shifted(x_high_, -1), x_low_, 0, s_.nx_ + 1, stage_.gravity, flux);
        pass(stage_.gates.west, flux, 0, 1);
        pass(stage_.gates.east, flux, s_.nx_, s_.nx_ + 1);
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
        const Real* __restrict h = water_.at(r).h;
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
            drain[i] = drain_part(h[i], per_dx * (high_x - low_x) + per_dy * (high_y - low_y), dt);
            const Real loss = dt * (per_dx * (x[i + 1] - x[i]) + per_dy * (y1[i] - y[i]));
            cuts |= drain[i] < 1 || slowing_depth(h[i] - loss) < h[i] ? 1 : 0;
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
        if constexpr (second) {
            if (stage_.friction > 0) rub(r);
            calm(r);
        }
    }

    template <bool drains>
    void advance(int r) {
        const int row = r;
        const Real *x_mass = x_flux_.at(r).mass, *x_along = x_flux_.at(r).along;
        const Real *y_mass = y_flux_.at(r).mass, *y_along = y_flux_.at(r).along;
        const Real *y1_mass = y_flux_.at(r + 1).mass, *y1_along = y_flux_.at(r + 1).along;
        const Real *push_x = x_push_.at(r), *push_y = y_push_.at(r);
        const Real *drain = drain_.at(r), *drain0 = drain_.at(r - 1), *drain1 = drain_.at(r + 1);
        const Real* depth = start_.depth.row(row);
        const Real *h = water_.at(r).h, *u = water_.at(r).u, *v0 = water_.at(r - 1).v, *v = water_.at(r).v,
                   *v1 = water_.at(r + 1).v;
        auto *rise = now_.rise.row(row), *qx = now_.qx.row(row), *qy = now_.qy.row(row);
        auto *more_rise = change_.rise.row(row), *more_qx = change_.qx.row(row), *more_qy = change_.qy.row(row);
        Real* carry = s_.carry_.row(row);
        const Real dt = stage_.dt, per_dx = stage_.per_dx, per_dy = stage_.per_dy;
        const Real none = 0, half = Real(0.5);
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
            const Real gain = dt * (per_dx * (west - east) + per_dy * (south - north));
            Real gain_x = dt * (push_x[i] + per_dy * (south_u - north_u));
            Real gain_y = dt * (push_y[i] + per_dx * (west_v - east_v));
            if constexpr (drains) {
                // Water that is held back keeps its momentum.
                gain_x += dt * per_dx *
                          (held_momentum(x_mass[i + 1] - east, u[i], u[i + 1]) -
                           held_momentum(x_mass[i] - west, u[i - 1], u[i]));
                gain_y +=
                    dt * per_dy *
                    (held_momentum(y1_mass[i] - north, v[i], v1[i]) - held_momentum(y_mass[i] - south, v0[i], v[i]));
                const Real part = kept_flow(h[i], h[i] + gain);
                const Real from_x = second ? qx[i] + more_qx[i] : qx[i];
                const Real from_y = second ? qy[i] + more_qy[i] : qy[i];
                gain_x = part * (from_x + gain_x) - from_x;
                gain_y = part * (from_y + gain_y) - from_y;
            }
            if constexpr (second) {
                const Real wanted = half * (more_rise[i] + gain) + carry[i];
                const Real reached = rise[i] + wanted;
                const Real next = reached < -depth[i] ? -depth[i] : reached;  // a NaN stays
                carry[i] = wanted - (next - rise[i]);
                rise[i] = next;
                qx[i] += half * (more_qx[i] + gain_x);
                qy[i] += half * (more_qy[i] + gain_y);
            } else {
                const Real empty = -(depth[i] + rise[i]);
                more_rise[i] = gain < empty ? empty : gain;
                more_qx[i] = gain_x;
                more_qy[i] = gain_y;
            }
        }
    }

    // The discharge of films follows their velocity. Finds the fastest waves: rates are compared as integers, which for
    // positive numbers have the same order, vectorise, and let a NaN come out on top.
    void calm(int r) {
        using Bits = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;
        const Real* __restrict depth = start_.depth.row(r);
        const Real* __restrict rise = now_.rise.row(r);
        Real* __restrict qx = now_.qx.row(r), * __restrict qy = now_.qy.row(r);
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
        const Real* __restrict rise = now_.rise.row(r);
        Real* __restrict qx = now_.qx.row(r), * __restrict qy = now_.qy.row(r);
        const Real friction = stage_.friction, film = stage_.film;
#pragma GCC ivdep
        for (int i = 0; i < s_.nx_; ++i) {
            const Real q = std::sqrt(qx[i] * qx[i] + qy[i] * qy[i]);
            const Real part = friction_part(depth[i] + rise[i], q, friction, film);
            qx[i] *= part;
            qy[i] *= part;
        }
    }

    ShallowSweep& s_;
    const ShallowStage<Real>& stage_;
    const ShallowStart<Real>& start_;
    Now& now_;
    Change& change_;
    int first_ = 0, last_ = 0;
    int lowest_ = 0, highest_ = 0;  // rows of cells with faces
    bool at_low_side_ = false, at_high_side_ = false;
    Ring<CellRow<Real>, 5> water_, ahead_;
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
    : nx_(nx), ny_(ny), periodic_x_(periodic_x), periodic_y_(periodic_y), carry_(nx, ny) {}

template <class Real>
template <bool second, class Now, class Change, class Work>
ShallowPeak ShallowSweep<Real>::in_bands(const ShallowStage<Real>& stage, const ShallowStart<Real>& start, Now& now,
                                         Change& change, Work work) {
    const int count = std::clamp(omp_get_max_threads(), 1, std::max(1, ny_ / least_rows));
    while (static_cast<int>(scratch_.size()) < count)
        scratch_.emplace_back(FramedRows<Real>::stride_for(nx_), Band<second>::scratch_rows);
    std::vector<Band<second>> bands;
    for (int b = 0; b < count; ++b)
        bands.emplace_back(*this, stage, start, now, change, scratch_[static_cast<std::size_t>(b)]);
    std::vector<ShallowPeak> peaks(bands.size());
    const auto edge = [&](int n) { return static_cast<int>(static_cast<std::int64_t>(ny_) * n / count); };
#pragma omp parallel num_threads(count)
    {
        const DenormalsAreZero guard;
#pragma omp for schedule(static, 1)
        for (int b = 0; b < count; ++b) bands[static_cast<std::size_t>(b)].prepare(edge(b), edge(b + 1));
#pragma omp for schedule(static, 1)
        for (int b = 0; b < count; ++b) peaks[static_cast<std::size_t>(b)] = work(bands[static_cast<std::size_t>(b)]);
    }
    ShallowPeak peak;
    for (const ShallowPeak& p : peaks) {
        peak.rate = std::max(peak.rate, p.rate);
        peak.finite = peak.finite && p.finite;
    }
    return peak;
}

template <class Real>
void ShallowSweep<Real>::rub(const ShallowStage<Real>& stage, const ShallowStart<Real>& start,
                             const ShallowFields<Real>& change, ShallowFields<Real>& now) {
    in_bands<true>(stage, start, now, change, [](Band<true>& band) { return band.rub(); });
}

template <class Real>
void ShallowSweep<Real>::first_stage(const ShallowStage<Real>& stage, const ShallowStart<Real>& start,
                                     const ShallowFields<Real>& now, ShallowFields<Real>& change) {
    in_bands<false>(stage, start, now, change, [](Band<false>& band) { return band.run(); });
}

template <class Real>
ShallowPeak ShallowSweep<Real>::second_stage(const ShallowStage<Real>& stage, const ShallowStart<Real>& start,
                                             const ShallowFields<Real>& change, ShallowFields<Real>& now) {
    return in_bands<true>(stage, start, now, change, [](Band<true>& band) { return band.run(); });
}

template <class Real>
ShallowPeak ShallowSweep<Real>::look(const ShallowStage<Real>& stage, const ShallowStart<Real>& start,
                                     const ShallowFields<Real>& change, ShallowFields<Real>& now) {
    return in_bands<true>(stage, start, now, change, [](Band<true>& band) { return band.look(); });
}

template class ShallowSweep<float>;
template class ShallowSweep<double>;

}  // namespace waterlight
