// Short ways to set up and read runs of the shallow-water model.
#pragma once

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>

#include "sim/random.hpp"
#include "sim/shallow_initial.hpp"
#include "sim/shallow_means.hpp"
#include "sim/shallow_water.hpp"

namespace waterlight::testing {

inline constexpr double g = standard_gravity_m_s2;

inline const ShallowSides walled{};
inline const ShallowSides periodic_all{PeriodicSide{}, PeriodicSide{}, PeriodicSide{}, PeriodicSide{}};
inline const ShallowSides periodic_along_y{WallSide{}, WallSide{}, PeriodicSide{}, PeriodicSide{}};

/// On the small grids of tests a second thread only costs.
inline const bool one_thread = (omp_set_num_threads(1), true);

/// Cells of the grid, given a value each by at(i, j).
template <class At>
Field<double> field_of(const Grid& grid, const At& at) {
    Field<double> field(grid.nx, grid.ny);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) field(i, j) = at(i, j);
    return field;
}

/// A flume along x, one cell wide, that is the same all along y.
inline ShallowWaterSettings flume(int cells, double length_m, ShallowSide west = WallSide{},
                                  ShallowSide east = WallSide{}) {
    ShallowWaterSettings settings;
    settings.grid = {cells, 1, length_m / cells, length_m / cells, 0, 0};
    settings.sides = {std::move(west), std::move(east), PeriodicSide{}, PeriodicSide{}};
    return settings;
}

/// A run that begins as an exact state, over its own ground.
inline ShallowWaterSettings settings_of(const ShallowExact& state, const Grid& grid, const ShallowSides& sides,
                                        double time_s = 0) {
    ShallowWaterSettings settings;
    settings.grid = grid;
    settings.sides = sides;
    settings.bed_m = bed_at_centres(state, grid);
    set_initial({ExactStart{state, time_s}}, settings);
    return settings;
}

/// Error of depth, relative, against the means over the cells of an exact state.
inline double relative_l1(const ShallowWaterModel& model, const Grid& grid, const Field<double>& exact) {
    double error = 0, sum = 0;
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            error += std::abs(model.state(i, j).depth_m - exact(i, j));
            sum += exact(i, j);
        }
    }
    return error / sum;
}

/// That of a double-precision run from start_s to end_s.
inline double error_after(const ShallowExact& state, const Grid& grid, const ShallowSides& sides, double start_s,
                          double end_s) {
    const auto model = make_shallow_water<double>(settings_of(state, grid, sides, start_s));
    model->advance(end_s - start_s);
    return relative_l1(*model, grid, cell_means(state, grid, end_s).depth_m);
}

/// The largest of value(state) over the cells.
template <class Value>
double largest(const ShallowWaterModel& model, const Grid& grid, const Value& value) {
    double most = value(model.state(0, 0));
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) most = std::max(most, double(value(model.state(i, j))));
    return most;
}

inline double speed_m_s(const ShallowState& s) { return std::hypot(s.velocity_m_s.x, s.velocity_m_s.y); }

inline double fastest_m_s(const ShallowWaterModel& model, const Grid& grid) { return largest(model, grid, speed_m_s); }

inline double shallowest_m(const ShallowWaterModel& model, const Grid& grid) {
    return -largest(model, grid, [](const ShallowState& s) { return -s.depth_m; });
}

/// Advances by `steps` steps or a few more.
inline void take_steps(ShallowWaterModel& model, std::int64_t steps) {
    const std::int64_t end = model.steps() + steps;
    while (model.steps() < end) model.advance(model.step_s() * static_cast<double>(std::min<std::int64_t>(steps, 50)));
}

/// Advances by steps of every_s until look(t) has seen the run at end_s.
template <class Look>
void watch(ShallowWaterModel& model, double every_s, double end_s, const Look& look) {
    const int frames = static_cast<int>(std::lround(end_s / every_s));
    for (int n = 1; n <= frames; ++n) {
        model.advance(every_s);
        look(n * every_s);
    }
}

/// The elevation (m) of the water in a cell.
inline double elevation_m(const ShallowWaterModel& model, int i, int j) {
    return model.bed_m(i, j) + model.state(i, j).depth_m;
}

/// 10^x for x uniform in [from, to).
inline double power_of_ten(RandomStream& random, double from, double to) {
    return std::pow(10, random.uniform(from, to));
}

}  // namespace waterlight::testing
