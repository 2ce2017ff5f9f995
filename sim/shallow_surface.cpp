#include "sim/shallow_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/kernels/shallow_water.hpp"

namespace waterlight {

namespace {

using f32::flow_per_discharge;
using f32::shore_slope;
using f64::flow_per_discharge;
using f64::shore_slope;

template <class Real>
void show_row(const ShallowView<Real>& view, int j, Surface& surface) {
    const ShallowStart<Real>& start = view.start;
    const Real film = static_cast<Real>(view.film_m);
    const float datum = static_cast<float>(start.datum_m);
    const Real per_dx = static_cast<Real>(1 / view.grid.dx_m), per_dy = static_cast<Real>(1 / view.grid.dy_m);
    const Real* __restrict s = start.surface.row(j);
    const Real* __restrict s0 = start.surface.row(j - 1);
    const Real* __restrict s1 = start.surface.row(j + 1);
    const Real* __restrict d = start.depth.row(j);
    const Real* __restrict d0 = start.depth.row(j - 1);
    const Real* __restrict d1 = start.depth.row(j + 1);
    const Real* __restrict r = view.now.rise.row(j);
    const Real* __restrict r0 = view.now.rise.row(j - 1);
    const Real* __restrict r1 = view.now.rise.row(j + 1);
    const Real* __restrict qx = view.now.qx.row(j);
    const Real* __restrict qy = view.now.qy.row(j);
    float* __restrict elevation = surface.elevation.row(j);
    float* __restrict slope_x = surface.slope_x.row(j);
    float* __restrict slope_y = surface.slope_y.row(j);
    float* __restrict u = surface.velocity_x->row(j);
    float* __restrict v = surface.velocity_y->row(j);
    float* __restrict depth = surface.depth->row(j);
#pragma GCC ivdep
    for (int i = 0; i < view.grid.nx; ++i) {
        const Real h = d[i] + r[i];
        const Real e = s[i] + r[i];
        const Real flow = flow_per_discharge(h, film);
        elevation[i] = static_cast<float>(e) + datum;
        depth[i] = static_cast<float>(h);
        u[i] = static_cast<float>(flow * qx[i]);
        v[i] = static_cast<float>(flow * qy[i]);
        slope_x[i] = static_cast<float>(per_dx * shore_slope(s[i - 1] + r[i - 1] - e, s[i + 1] + r[i + 1] - e,
                                                             d[i - 1] + r[i - 1], h, d[i + 1] + r[i + 1], film));
        slope_y[i] = static_cast<float>(
            per_dy * shore_slope(s0[i] + r0[i] - e, s1[i] + r1[i] - e, d0[i] + r0[i], h, d1[i] + r1[i], film));
    }
}

/// Sums over one row, so that totals are the same for any number of threads.
template <class Real>
ShallowTotals row_totals(const ShallowView<Real>& view, int j, double wet_m) {
    ShallowTotals sum;
    const double half_weight = 0.5 * view.water.density_kg_m3 * view.water.gravity_m_s2;
    for (int i = 0; i < view.grid.nx; ++i) {
        const ShallowState at = state_of(view, i, j);
        const double h = at.depth_m, ground = ground_of(view.start, i, j);
        const double dry_level = std::max(ground, 0.0);  // of still water, or of the ground above it
        const double e = view.start.datum_m + view.start.surface.row(j)[i] + view.now.rise.row(j)[i];
        sum.volume_m3 += h;
        sum.momentum_x_kg_m_s += h * at.velocity_m_s.x;
        sum.momentum_y_kg_m_s += h * at.velocity_m_s.y;
        sum.potential_j += half_weight * (e - dry_level) * (e + dry_level);
        sum.kinetic_j += 0.5 * h * dot(at.velocity_m_s, at.velocity_m_s);
        sum.inundated_m2 += h > wet_m ? 1 : 0;
    }
    return sum;
}

}  // namespace

template <class Real>
ShallowState state_of(const ShallowView<Real>& view, int i, int j) {
    const double h = static_cast<double>(view.start.depth.row(j)[i]) + view.now.rise.row(j)[i];
    const double flow = f64::flow_per_discharge(h, view.film_m);
    return {h, {flow * view.now.qx.row(j)[i], flow * view.now.qy.row(j)[i]}};
}

template <class Real>
double ground_of(const ShallowStart<Real>& start, int i, int j) {
    return start.datum_m + start.surface.row(j)[i] - start.depth.row(j)[i];
}

template <class Real>
ShallowTotals shallow_totals(const ShallowView<Real>& view, double wet_m) {
    std::vector<ShallowTotals> rows(static_cast<std::size_t>(view.grid.ny));
#pragma omp parallel for schedule(static)
    for (int j = 0; j < view.grid.ny; ++j) rows[static_cast<std::size_t>(j)] = row_totals(view, j, wet_m);
    const double area = view.grid.cell_area_m2(), mass = area * view.water.density_kg_m3;
    ShallowTotals sum;
    for (const ShallowTotals& row : rows) {
        sum.volume_m3 += area * row.volume_m3;
        sum.momentum_x_kg_m_s += mass * row.momentum_x_kg_m_s;
        sum.momentum_y_kg_m_s += mass * row.momentum_y_kg_m_s;
        sum.potential_j += area * row.potential_j;
        sum.kinetic_j += mass * row.kinetic_j;
        sum.inundated_m2 += area * row.inundated_m2;
    }
    return sum;
}

template <class Real>
void show_surface(const ShallowView<Real>& view, Surface& surface) {
    for (auto* field : {&surface.velocity_x, &surface.velocity_y, &surface.depth})
        if (!*field) field->emplace(view.grid.nx, view.grid.ny);
#pragma omp parallel for schedule(static)
    for (int j = 0; j < view.grid.ny; ++j) show_row(view, j, surface);
}

WaveDiagnostics shallow_diagnostics(const Surface& surface, const ShallowTotals& totals) {
    double wet = 0, sum = 0, squares = 0, slopes = 0, highest = 0;
    const std::span<const float> depth = surface.depth->values();
    for (std::size_t k = 0; k < depth.size(); ++k) {
        if (!(depth[k] > 0)) continue;
        const double e = surface.elevation.data()[k];
        const double sx = surface.slope_x.data()[k], sy = surface.slope_y.data()[k];
        wet += 1;
        sum += e;
        squares += e * e;
        slopes += sx * sx + sy * sy;
        highest = std::max(highest, std::abs(e));
    }
    WaveDiagnostics d;
    d.volume_m3 = totals.volume_m3;
    d.energy_j = totals.potential_j + totals.kinetic_j;
    d.max_abs_elevation_m = highest;
    if (wet == 0) return d;
    d.variance_m2 = std::max(0.0, squares / wet - (sum / wet) * (sum / wet));
    d.slope_variance = slopes / wet;
    return d;
}

template <class Real>
std::string fastest_cell(const ShallowView<Real>& view) {
    int at_i = 0, at_j = 0;
    double most = -1;
    for (int j = 0; j < view.grid.ny && std::isfinite(most); ++j) {
        for (int i = 0; i < view.grid.nx && std::isfinite(most); ++i) {
            const ShallowState s = state_of(view, i, j);
            const double rate = f64::crossing_rate(s.depth_m, s.velocity_m_s.x, s.velocity_m_s.y,
                                                   view.water.gravity_m_s2, 1 / view.grid.dx_m, 1 / view.grid.dy_m);
            if (rate <= most) continue;
            most = rate;
            at_i = i;
            at_j = j;
        }
    }
    const ShallowState s = state_of(view, at_i, at_j);
    return fmt::format(
        "cell ({}, {}) at ({:.6g}, {:.6g}) m: depth {:.6g} m, velocity ({:.6g}, {:.6g}) m/s, ground {:.6g} m", at_i,
        at_j, view.grid.x_m(at_i), view.grid.y_m(at_j), s.depth_m, s.velocity_m_s.x, s.velocity_m_s.y,
        ground_of(view.start, at_i, at_j));
}

#define WATERLIGHT_SHALLOW_VIEW(Real)                                              \
    template ShallowState state_of<Real>(const ShallowView<Real>&, int, int);      \
    template double ground_of<Real>(const ShallowStart<Real>&, int, int);          \
    template ShallowTotals shallow_totals<Real>(const ShallowView<Real>&, double); \
    template void show_surface<Real>(const ShallowView<Real>&, Surface&);          \
    template std::string fastest_cell<Real>(const ShallowView<Real>&);
WATERLIGHT_SHALLOW_VIEW(float)
WATERLIGHT_SHALLOW_VIEW(double)

}  // namespace waterlight
