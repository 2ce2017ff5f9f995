#include "sim/prescribed_formula.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "sim/error.hpp"
#include "sim/kernels/dispersion.hpp"

namespace waterlight {

SumFormula::SumFormula(const PrescribedSettings& settings) : slope_(settings.slope), sines_(settings.sines) {
    const Water& water = settings.water;
    for (const Sine& sine : sines_) {
        if (!(sine.wavelength_m > 0)) throw InputError("prescribed: a sine's wavelength must be above 0");
        const double k = 2 * std::numbers::pi / sine.wavelength_m;
        const double tension = water.surface_tension_n_m / water.density_kg_m3;
        const double omega2 = f64::airy_omega2(k, water.depth_m, water.gravity_m_s2, tension);
        omega_.push_back(sine.frozen ? 0 : std::sqrt(omega2));
    }
    if (settings.gerstner) {
        gerstner_.emplace(gerstner_waves(*settings.gerstner, settings.grid, settings.boundary, water));
    }
}

SurfacePoint SumFormula::at(glm::dvec2 at_m, double time_s) const {
    SurfacePoint sum;
    if (gerstner_) sum = gerstner_->at(at_m, time_s);
    sum.elevation_m += glm::dot(slope_, at_m);
    sum.slope += slope_;
    for (std::size_t n = 0; n < sines_.size(); ++n) {
        const SurfacePoint sine = evaluate(sines_[n], omega_[n], at_m, time_s);
        sum.elevation_m += sine.elevation_m;
        sum.slope += sine.slope;
        sum.rate_m_s += sine.rate_m_s;
    }
    return sum;
}

// cos(kx x) and sin(kx x) of a sine at the columns: with those of the rest of its phase, one pair a row, the addition
// theorem gives the sine at every cell.
struct SumFormula::Columns {
    std::vector<double> cosine;
    std::vector<double> sine;
};

std::vector<SumFormula::Columns> SumFormula::columns_of(const Grid& grid) const {
    std::vector<Columns> all;
    for (const Sine& sine : sines_) {
        const double kx = wave_vector(sine).x;
        Columns& columns = all.emplace_back();
        for (int i = 0; i < grid.nx; ++i) {
            columns.cosine.push_back(std::cos(kx * grid.x_m(i)));
            columns.sine.push_back(std::sin(kx * grid.x_m(i)));
        }
    }
    return all;
}

void SumFormula::set_row(Surface& surface, int j, double time_s, const std::vector<Columns>& columns) const {
    const Grid& grid = surface.grid;
    const double y = grid.y_m(j);
    const auto nx = static_cast<std::size_t>(grid.nx);
    std::vector<double> elevation(nx);
    std::vector<double> slope_x(nx, slope_.x);
    std::vector<double> slope_y(nx, slope_.y);
    for (std::size_t i = 0; i < nx; ++i) elevation[i] = slope_.x * grid.x_m(static_cast<int>(i)) + slope_.y * y;
    for (std::size_t n = 0; n < sines_.size(); ++n) {
        // The sine's formula on the line x = 0 gives a cos and -k a sin of the rest of the phase.
        const SurfacePoint rest = evaluate(sines_[n], omega_[n], {0, y}, time_s);
        const glm::dvec2 k = wave_vector(sines_[n]);
        const double a_cos = rest.elevation_m;
        const double a_sin = -glm::dot(rest.slope, k) / glm::dot(k, k);
        const double* __restrict cosine = columns[n].cosine.data();
        const double* __restrict sine = columns[n].sine.data();
#pragma GCC ivdep
        for (std::size_t i = 0; i < nx; ++i) {
            const double here_sin = sine[i] * a_cos + cosine[i] * a_sin;
            elevation[i] += cosine[i] * a_cos - sine[i] * a_sin;
            slope_x[i] -= k.x * here_sin;
            slope_y[i] -= k.y * here_sin;
        }
    }
    std::copy(elevation.begin(), elevation.end(), surface.elevation.row(j));
    std::copy(slope_x.begin(), slope_x.end(), surface.slope_x.row(j));
    std::copy(slope_y.begin(), slope_y.end(), surface.slope_y.row(j));
    if (gerstner_) {
        gerstner_->add_row(grid, j, time_s, {surface.elevation.row(j), surface.slope_x.row(j), surface.slope_y.row(j)});
    }
}

void SumFormula::evaluate_on(Surface& surface, double time_s) const {
    const std::vector<Columns> columns = columns_of(surface.grid);
#pragma omp parallel for schedule(static)
    for (int j = 0; j < surface.grid.ny; ++j) set_row(surface, j, time_s, columns);
}

}  // namespace waterlight
