// The loops over a row that a step of the shallow-water model is made of: from the state to water, faces and fluxes.
// The compiler vectorises them: what they write overlaps nothing that they read; neighbours are rows beside or rows
// shifted.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "sim/kernels/shallow_water.hpp"
#include "sim/shallow_rows.hpp"
#include "sim/shallow_solver.hpp"

namespace waterlight::row_loops {

/// Rows of scratch memory that come round: row r lies where row r - N lay.
template <class Row, int N>
struct Ring {
    std::array<Row, N> rows;
    Row& at(int r) { return rows[static_cast<std::size_t>((r + 8 * N) % N)]; }
};

/// Water of a row of cells.
template <class Real>
struct CellRow {
    Real *e, *h, *u, *v, *z;
};

/// Water at one side of the faces of a row; u across, v along the face.
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

using f32::carried_steps;
using f32::face_depth;
using f32::flow_per_discharge;
using f32::ground_step;
using f32::limited_steps;
using f32::shallow_flux;
using f32::slope_freedom;
using f32::surface_force;
using f64::carried_steps;
using f64::face_depth;
using f64::flow_per_discharge;
using f64::ground_step;
using f64::limited_steps;
using f64::shallow_flux;
using f64::slope_freedom;
using f64::surface_force;

/// Surface, depth, velocity and ground of cells -2 to nx + 1 of a row, of `now` or of now + change.
template <bool with_change, class Real>
void find_water(const ShallowStart<Real>& start, const ShallowFields<Real>& now, const ShallowFields<Real>& change,
                int row, Real film, const CellRow<Real>& to) {
    const Real* __restrict surface = start.surface.row(row);
    const Real* __restrict depth = start.depth.row(row);
    const Real* __restrict rise = now.rise.row(row);
    const Real* __restrict qx = now.qx.row(row);
    const Real* __restrict qy = now.qy.row(row);
    const Real* __restrict more_rise = change.rise.row(row);
    const Real* __restrict more_qx = change.qx.row(row);
    const Real* __restrict more_qy = change.qy.row(row);
    Real* __restrict e = to.e;
    Real* __restrict h = to.h;
    Real* __restrict u = to.u;
    Real* __restrict v = to.v;
    Real* __restrict z = to.z;
    const int nx = start.depth.nx();
#pragma GCC ivdep
    for (int i = -2; i < nx + 2; ++i) {
        const Real up = with_change ? rise[i] + more_rise[i] : rise[i];
        const Real deep = depth[i] + up < 0 ? 0 : depth[i] + up;  // a NaN stays
        const Real flow = flow_per_discharge(deep, film);
        e[i] = surface[i] + up;
        h[i] = deep;
        u[i] = flow * (with_change ? qx[i] + more_qx[i] : qx[i]);
        v[i] = flow * (with_change ? qy[i] + more_qy[i] : qy[i]);
        z[i] = surface[i] - depth[i];
    }
}

/// Water at both faces of cells [from, to) along one axis, and the force of the surface between them. `before` and
/// `after` are the neighbours along the axis: the rows beside, or the same row shifted.
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
        const Steps across = carried_steps(limited_steps(u[i] - u0[i], u1[i] - u[i], freedom), h[i], gravity);
        const Steps along = limited_steps(v[i] - v0[i], v1[i] - v[i], freedom);
        const Real e_low = e[i] - rise.low;
        const Real e_high = e[i] + rise.high;
        const Real h_low = face_depth(h[i], ground - rise.low);
        const Real h_high = face_depth(h[i], rise.high - ground);
        le[i] = e_low;
        he[i] = e_high;
        lh[i] = h_low;
        hh[i] = h_high;
        lu[i] = u[i] - across.low;
        hu[i] = u[i] + across.high;
        lv[i] = v[i] - along.low;
        hv[i] = v[i] + along.high;
        force[i] = surface_force(gravity, h_low, h_high, e_low, e_high);
    }
}

/// Flux through faces [from, to): `low` and `high` are the water on their low and high sides.
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

/// Rate of change (m2/s2) of the discharge across the faces of cells [0, nx). `before` and `after` are their faces.
template <class Real>
void find_push(const Real* before_push_high, const Real* after_push_low, const Real* __restrict force, int nx,
               Real per_d, Real* __restrict push) {
#pragma GCC ivdep
    for (int i = 0; i < nx; ++i) push[i] = per_d * (before_push_high[i] - after_push_low[i] - force[i]);
}

/// Lets through faces [from, to) what is given. It has no velocity along the side.
template <class Real>
void pass(const ShallowGate& gate, const FluxRow<Real>& flux, int from, int to) {
    if (!gate.given) return;
    std::fill(flux.mass + from, flux.mass + to, static_cast<Real>(gate.discharge_m2_s));
    std::fill(flux.along + from, flux.along + to, Real(0));
}

template <class Real>
CellRow<Real> shifted(const CellRow<Real>& r, int by) {
    return {r.e + by, r.h + by, r.u + by, r.v + by, r.z + by};
}
template <class Real>
FaceRow<Real> shifted(const FaceRow<Real>& r, int by) {
    return {r.e + by, r.h + by, r.u + by, r.v + by};
}

}  // namespace waterlight::row_loops
