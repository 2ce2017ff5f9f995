// The same bytes for any number of threads.
#include <gtest/gtest.h>

#include <vector>

#include "tests/support/shallow_runs.hpp"

namespace waterlight::testing {
namespace {

/// Everything that moves and rubs at once: shores, cliffs, drops, records, sides of several kinds.
ShallowWaterSettings busy_water(int nx, int ny, bool periodic) {
    RandomStream random(9, 0);
    ShallowWaterSettings settings;
    settings.grid = make_grid(nx, ny, 6, 5);
    settings.bed_m = field_of(settings.grid, [&](int, int) { return random.uniform(-0.5, 0.2); });
    settings.manning = 0.02;
    settings.keep_records = true;
    settings.sources = {Rain{2, {0.2, 0.6}, {-0.1, 0.1}, 0, 1e30, 4}};
    settings.sides = {IncidentSide{{{0, 1, 2}, {0, 0.1, 0}}}, OpenSide{}, WallSide{}, LevelSide{constant_series(0.1)}};
    if (periodic) settings.sides = periodic_all;
    set_initial({CircularDam{{2, 2}, 1, 0.5, 0}}, settings);
    return settings;
}

template <class Real>
std::vector<double> bytes_of_run(const ShallowWaterSettings& settings, int threads) {
    omp_set_num_threads(threads);
    const auto model = make_shallow_water<Real>(settings);
    watch(*model, 0.05, 0.3, [](double) {});
    std::vector<double> all;
    for (int j = 0; j < settings.grid.ny; ++j) {
        for (int i = 0; i < settings.grid.nx; ++i) {
            const ShallowState s = model->state(i, j);
            all.insert(all.end(), {s.depth_m, s.velocity_m_s.x, s.velocity_m_s.y});
        }
    }
    for (const auto* field : {&model->records()->max_elevation_m, &model->records()->arrival_s})
        for (const float value : field->values()) all.push_back(std::isnan(value) ? -1e9 : double(value));
    const ShallowTotals t = model->totals();
    all.insert(all.end(), {t.volume_m3, t.momentum_x_kg_m_s, t.kinetic_j, t.potential_j});
    omp_set_num_threads(1);
    return all;
}

TEST(ShallowThreads, GiveTheSameBytes) {
    for (const auto& [nx, ny] : {std::pair{37, 29}, std::pair{33, 12}, std::pair{40, 3}}) {
        for (const bool periodic : {false, true}) {
            const ShallowWaterSettings settings = busy_water(nx, ny, periodic);
            const auto alone = bytes_of_run<float>(settings, 1);
            const auto alone_double = bytes_of_run<double>(settings, 1);
            for (const int threads : {2, 3}) {
                EXPECT_EQ(bytes_of_run<float>(settings, threads), alone) << nx << " x " << ny << ", " << threads;
                EXPECT_EQ(bytes_of_run<double>(settings, threads), alone_double) << nx << " x " << ny;
            }
        }
    }
}

}  // namespace
}  // namespace waterlight::testing
