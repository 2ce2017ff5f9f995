#include "sim/linear_energy.hpp"

#include <fftw3.h>

#include <memory>
#include <numbers>
#include <vector>

#include "sim/kernels/linear.hpp"

namespace waterlight {

namespace {

// The modes of one axis: FFTW's transform to them, minus the second difference of each over itself, and what its
// squared coefficient counts in the sum of squares of the values.
struct Modes {
    fftw_r2r_kind kind;
    std::vector<double> wave_number2;
    std::vector<double> weight;
};

Modes modes_of(Side side, int n, double cell) {
    Modes modes{FFTW_R2HC, {}, {}};
    if (side == Side::wall) modes.kind = FFTW_REDFT10;
    if (side == Side::absorbing) modes.kind = FFTW_RODFT00;
    for (int m = 0; m < n; ++m) {
        double k = 2 * std::numbers::pi * m / (n * cell);
        double weight = (m == 0 || 2 * m == n ? 1.0 : 2.0) / n;
        if (side == Side::wall) {
            k = std::numbers::pi * m / (n * cell);
            weight = (m == 0 ? 0.25 : 0.5) / n;
        } else if (side == Side::absorbing) {
            k = std::numbers::pi * (m + 1) / ((n + 1) * cell);
            weight = 0.5 / (n + 1);
        }
        modes.wave_number2.push_back(f64::discrete_wave_number2(k, cell));
        modes.weight.push_back(weight);
    }
    return modes;
}

void transform(Field<double>& values, const Modes& x, const Modes& y) {
    struct Destroy {
        void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
    };
    const std::unique_ptr<fftw_plan_s, Destroy> plan(
        fftw_plan_r2r_2d(values.ny(), values.nx(), values.data(), values.data(), y.kind, x.kind, FFTW_ESTIMATE));
    fftw_execute(plan.get());
}

}  // namespace

double linear_energy(LinearState state) {
    const Grid& grid = state.grid;
    const Modes x = modes_of(state.boundary.x, grid.nx, grid.dx_m);
    const Modes y = modes_of(state.boundary.y, grid.ny, grid.dy_m);
    transform(state.elevation_m, x, y);
    transform(state.rate_m_s, x, y);
    const Water& water = state.water;
    const double c = f64::long_wave_speed(water.gravity_m_s2, water.depth_m);
    double squared_amplitudes = 0;
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            const double kx2 = x.wave_number2[static_cast<std::size_t>(i)];
            const double ky2 = y.wave_number2[static_cast<std::size_t>(j)];
            squared_amplitudes +=
                x.weight[static_cast<std::size_t>(i)] * y.weight[static_cast<std::size_t>(j)] *
                f64::leapfrog_amplitude2(state.elevation_m(i, j), state.rate_m_s(i, j), c, state.dt_s, kx2 + ky2);
        }
    }
    return 0.5 * water.density_kg_m3 * water.gravity_m_s2 * grid.cell_area_m2() * squared_amplitudes;
}

}  // namespace waterlight
