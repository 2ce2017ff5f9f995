#include "sim/airy_modes.hpp"

#include <cmath>

#include "sim/airy_dispersion.hpp"
#include "sim/airy_phase.hpp"

namespace waterlight {

namespace {

AxisBasis axis_basis(Side side, int n, double spacing_m, double corner_m) {
    const auto kind = side == Side::wall ? AxisBasis::Kind::cosine : AxisBasis::Kind::fourier;
    return {kind, n, spacing_m, corner_m};
}

/// One row of modes: e = a c + b s, and q = b c - a s.
void rotate_row(int n, const double* __restrict a, const double* __restrict b, const float* __restrict c,
                const float* __restrict s, float* __restrict e) {
#pragma GCC ivdep
    for (int i = 0; i < n; ++i) e[i] = static_cast<float>(a[i]) * c[i] + static_cast<float>(b[i]) * s[i];
}

}  // namespace

AiryModes make_airy_modes(const Grid& grid, const Boundary& boundary, const Water& water, glm::ivec2 margin_cells) {
    AiryModes modes;
    modes.water = water;
    modes.tank = {grid.nx + 2 * margin_cells.x,           grid.ny + 2 * margin_cells.y,          grid.dx_m, grid.dy_m,
                  grid.x0_m - margin_cells.x * grid.dx_m, grid.y0_m - margin_cells.y * grid.dy_m};
    modes.visible = {margin_cells.x, margin_cells.y, grid.nx, grid.ny};
    const Grid& tank = modes.tank;
    modes.x = axis_basis(boundary.x, tank.nx, tank.dx_m, tank.x0_m);
    modes.y = axis_basis(boundary.y, tank.ny, tank.dy_m, tank.y0_m);
    modes.omega = Field<double>(modes.x.distinct(), modes.y.distinct());
#pragma omp parallel for schedule(static)
    for (int q = 0; q < modes.omega.ny(); ++q)
        for (int p = 0; p < modes.omega.nx(); ++p)
            modes.omega.row(q)[p] = airy_omega(std::hypot(modes.x.wave_number(p), modes.y.wave_number(q)), water);
    return modes;
}

void evaluate_modes(const AiryModes& modes, const AiryState& state, double time_s, Field<float>& elevation,
                    Field<float>* quadrature) {
    const int nx = modes.x.n;
#pragma omp parallel
    {
        Field<float> phase(nx, 3);
        float *c = phase.row(0), *s = phase.row(1), *minus_s = phase.row(2);
#pragma omp for schedule(static)
        for (int wave = 0; wave < modes.y.distinct(); ++wave) {
            phase_row(modes.omega.row(wave), modes.x.distinct(), time_s - state.start_s, c, s);
            spread_to_slots(modes.x, c);
            spread_to_slots(modes.x, s);
            for (int i = 0; i < nx; ++i) minus_s[i] = -s[i];
            const int partner = modes.y.partner_of(wave);
            for (int j = wave;; j = partner) {
                rotate_row(nx, state.a.row(j), state.b.row(j), c, s, elevation.row(j));
                if (quadrature) rotate_row(nx, state.b.row(j), state.a.row(j), c, minus_s, quadrature->row(j));
                if (j == partner) break;
            }
        }
    }
}

double plane_energy_j(const AiryModes& modes, const Field<float>& plane) {
    const Water& water = modes.water;
    const double tension = water.surface_tension_n_m / water.density_kg_m3;
    double energy = 0;
    for (int j = 0; j < modes.y.n; ++j) {
        const double ky = modes.y.wave_number(modes.y.wave_of(j));
        double row = 0;
        for (int i = 0; i < modes.x.n; ++i) {
            const double kx = modes.x.wave_number(modes.x.wave_of(i));
            const double e = plane.row(j)[i];
            row += (water.gravity_m_s2 + tension * (kx * kx + ky * ky)) * e * e * modes.x.mean_square(i);
        }
        energy += row * modes.y.mean_square(j);
    }
    return 0.5 * water.density_kg_m3 * modes.area_m2() * energy;
}

}  // namespace waterlight
