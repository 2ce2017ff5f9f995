#include "sim/shallow_means.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "sim/quadrature.hpp"

namespace waterlight {

namespace {

/// Weighted sums of the conserved quantities, and of the length of the discharge, which is their scale.
struct Sums {
    double depth = 0;
    glm::dvec2 discharge{0, 0};
    double flow = 0;

    void add(double weight, const ShallowState& state) {
        const double mass = weight * state.depth_m;
        depth += mass;
        discharge += mass * state.velocity_m_s;
        flow += mass * glm::length(state.velocity_m_s);
    }
    void add(double weight, const Sums& part) {
        depth += weight * part.depth;
        discharge += weight * part.discharge;
        flow += weight * part.flow;
    }
};

bool agree(const Sums& a, const Sums& b) {
    constexpr double tolerance = 1e-12;
    return std::abs(a.depth - b.depth) <= tolerance * b.depth &&
           glm::length(a.discharge - b.discharge) <= tolerance * b.flow;
}

template <class State>
Sums refined_mean(const State& at, const Rectangle& box, const Sums& whole, int halvings) {
    const double w = 0.5 * box.width;
    const double h = 0.5 * box.height;
    const std::array<Rectangle, 4> quarters{{{box.x0, box.y0, w, h},
                                             {box.x0 + w, box.y0, w, h},
                                             {box.x0, box.y0 + h, w, h},
                                             {box.x0 + w, box.y0 + h, w, h}}};
    std::array<Sums, 4> parts;
    Sums sum;
    for (std::size_t n = 0; n < 4; ++n) {
        parts[n] = lobatto_mean<Sums>(at, quarters[n]);
        sum.add(0.25, parts[n]);
    }
    if (halvings <= 1 || agree(whole, sum)) return sum;
    sum = {};
    for (std::size_t n = 0; n < 4; ++n) sum.add(0.25, refined_mean(at, quarters[n], parts[n], halvings - 1));
    return sum;
}

}  // namespace

ShallowMeans cell_means(const ShallowExact& state, const Grid& grid, double time_s) {
    ShallowMeans means{{grid.nx, grid.ny}, {grid.nx, grid.ny}, {grid.nx, grid.ny}};
    std::visit(
        [&](const auto& exact) {
            const auto at = [&](double x, double y) { return exact.exact(x, y, time_s); };
#pragma omp parallel for schedule(dynamic)
            for (int j = 0; j < grid.ny; ++j) {
                for (int i = 0; i < grid.nx; ++i) {
                    const Rectangle cell{grid.x0_m + i * grid.dx_m, grid.y0_m + j * grid.dy_m, grid.dx_m, grid.dy_m};
                    const Sums mean = refined_mean(at, cell, lobatto_mean<Sums>(at, cell), 7);
                    means.depth_m(i, j) = mean.depth;
                    means.discharge_x_m2_s(i, j) = mean.discharge.x;
                    means.discharge_y_m2_s(i, j) = mean.discharge.y;
                }
            }
        },
        state);
    return means;
}

Field<double> bed_at_centres(const ShallowExact& state, const Grid& grid) {
    Field<double> bed(grid.nx, grid.ny);
    std::visit(
        [&](const auto& exact) {
            for (int j = 0; j < grid.ny; ++j)
                for (int i = 0; i < grid.nx; ++i) bed(i, j) = exact.bed(grid.x_m(i), grid.y_m(j));
        },
        state);
    return bed;
}

}  // namespace waterlight
