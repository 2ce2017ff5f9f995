// Depth is never negative, and in closed or periodic basins volume is constant to rounding.
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>

#include "tests/support/shallow_runs.hpp"

namespace waterlight::testing {
namespace {

template <class Real>
class ShallowVolume : public ::testing::Test {
  public:
    /// Each step and source rounds every cell once more, at random: after n of them a cell's surface may be off by
    /// eps sqrt(n) of the deepest water, all cells by the root of their number; thrice that is allowed.
    static double bound_m3(const Grid& grid, double deepest_m, double roundings) {
        const double cells = static_cast<double>(grid.cells());
        return 3 * std::numeric_limits<Real>::epsilon() * deepest_m * grid.cell_area_m2() *
               std::sqrt(cells * (1 + roundings));
    }

    /// Ten times what water reaches that falls through all of the relief and what sources heap up, and that runs apart
    /// from where it is fastest at the start. A thin layer on a cliff gains speed for a whole step before it leaves:
    /// that is why ten times.
    static double energetic_m_s(const ShallowWaterSettings& s, double heaped_m) {
        double low = std::numeric_limits<double>::infinity(), high = -low, fastest = 0;
        for (int j = 0; j < s.grid.ny; ++j) {
            for (int i = 0; i < s.grid.nx; ++i) {
                const double bed = s.bed_m.empty() ? -s.water.depth_m : s.bed_m(i, j);
                low = std::min(low, bed);
                high = std::max(high, bed + s.depth_m(i, j));
                fastest = std::max(fastest, std::hypot(s.velocity_x_m_s.empty() ? 0 : s.velocity_x_m_s(i, j),
                                                       s.velocity_y_m_s.empty() ? 0 : s.velocity_y_m_s(i, j)));
            }
        }
        return 10 * (std::sqrt(2 * g * (high - low + heaped_m)) + fastest);
    }

    static void expect_kept(const ShallowWaterSettings& settings, double end_s, const std::string& what,
                            std::int64_t most_steps = 2000, double heaped_m = 0) {
        const auto model = make_shallow_water<Real>(settings);
        const Grid& grid = settings.grid;
        const double before = model->totals().volume_m3;
        const auto depth = [](const ShallowState& s) { return s.depth_m; };
        double deepest = largest(*model, grid, depth);
        const double fall_m_s = energetic_m_s(settings, heaped_m);
        for (double t = 0; t < end_s && model->steps() < most_steps;) {
            const double frame = std::min(end_s - t, 10 * model->step_s());
            model->advance(frame);
            t += frame;
            ASSERT_GE(shallowest_m(*model, grid), 0) << what << " at " << t << " s";
            ASSERT_LE(fastest_m_s(*model, grid), fall_m_s) << what << " at " << t << " s";
            deepest = std::max(deepest, largest(*model, grid, depth));
        }
        ASSERT_GT(model->steps(), 0) << what;
        EXPECT_NEAR(model->totals().volume_m3, before, bound_m3(grid, deepest, static_cast<double>(model->steps())))
            << what << " after " << model->steps() << " steps";
    }
};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ShallowVolume, Precisions);

TYPED_TEST(ShallowVolume, DamBreaksOnDryGround) {
    for (const double cfl : {0.1, 0.5, 1.0}) {
        ShallowWaterSettings settings;
        settings.grid = make_grid(40, 30, 4, 3);
        settings.bed_m = field_of(settings.grid, [](int i, int j) { return 0.01 * ((i * 7 + j * 13) % 5); });
        settings.cfl = cfl;
        set_initial({CircularDam{{1.2, 1.1}, 0.8, 1, -1}}, settings);
        this->expect_kept(settings, 3, "round dam, cfl " + std::to_string(cfl));
    }
}

TYPED_TEST(ShallowVolume, BowlsWithMovingShores) {
    const Grid grid = make_grid(40, 40, 4, 4);
    for (const ShallowExact& state : {ShallowExact{ThackerPlanar{}}, ShallowExact{ThackerRadial{}}}) {
        for (const double cfl : {0.3, 1.0}) {
            ShallowWaterSettings settings = settings_of(state, grid, walled);
            settings.cfl = cfl;
            this->expect_kept(settings, 5, "bowl, cfl " + std::to_string(cfl));
        }
    }
}

TYPED_TEST(ShallowVolume, DropsIntoDryAndNearlyDryCells) {
    RandomStream random(5, 0);
    ShallowWaterSettings settings;
    settings.grid = make_grid(30, 24, 3, 2.4);
    settings.bed_m = field_of(settings.grid, [&](int, int) { return random.uniform(-0.02, 0.02); });
    settings.depth_m =
        field_of(settings.grid, [&](int, int) { return random.uniform() < 0.5 ? 0 : power_of_ten(random, -9, -1); });
    settings.sources = {Rain{40, {0.05, 0.3}, {-0.2, 0.2}, 0, 1e30, 3}, Drop{{1, 1}, 0.5, -5, 0},
                        Drop{{2, 1}, 0.5, 5, 0.1}, Wavemaker{{0, 1.2}, {3, 1.2}, 0.02, 0.4}};
    settings.depth_m(15, 12) = 0.1;
    for (const auto& sides : {walled, periodic_all}) {
        settings.sides = sides;
        this->expect_kept(settings, 2, "rain", 2000, 5);
    }
}

TYPED_TEST(ShallowVolume, NothingPassesWalls) {
    RandomStream random(6, 0);
    for (int n = 0; n < 100; ++n) {
        ShallowWaterSettings settings;
        settings.grid = {1, 1, power_of_ten(random, -2, 2), power_of_ten(random, -2, 2), 0, 0};
        settings.depth_m = field_of(settings.grid, [&](int, int) { return power_of_ten(random, -12, 4); });
        const double c = std::sqrt(g * settings.depth_m(0, 0));
        settings.velocity_x_m_s = field_of(settings.grid, [&](int, int) { return c * random.uniform(-2, 2); });
        settings.velocity_y_m_s = field_of(settings.grid, [&](int, int) { return c * random.uniform(-2, 2); });
        const auto model = make_shallow_water<TypeParam>(settings);
        const double before = model->state(0, 0).depth_m;
        take_steps(*model, 50);
        EXPECT_EQ(model->state(0, 0).depth_m, before);
    }
}

/// Random water over random ground with cliffs. Depths from 1e-12 to 1e4 m, Froude numbers to 100.
ShallowWaterSettings random_water(std::uint64_t seed) {
    RandomStream random(seed, 1);
    const auto pick = [&](auto... values) {
        const std::array list{values...};
        return list[static_cast<std::size_t>(random.uniform(0, double(list.size())))];
    };
    ShallowWaterSettings settings;
    const auto [nx, ny] = pick(std::pair{1, 1}, std::pair{2, 2}, std::pair{1, 17}, std::pair{19, 1}, std::pair{3, 2},
                               std::pair{13, 11}, std::pair{16, 9});
    settings.grid = {nx, ny, pick(0.01, 1.0, 100.0), pick(1.0, 0.7), 0, 0};
    settings.sides = pick(0, 1) ? walled : periodic_all;
    settings.cfl = pick(0.1, 0.5, 0.8, 1.0);
    settings.manning = pick(0.0, 0.0, 0.03);
    const double deepest = pick(-11.0, -3.0, 0.0, 2.0, 4.0), cliff = pick(0.0, 1.0, 3.0);
    settings.depth_m = field_of(settings.grid, [&](int, int) {
        return random.uniform() < 0.3 ? 0 : power_of_ten(random, std::max(-12.0, deepest - 8), deepest);
    });
    settings.bed_m = field_of(settings.grid, [&](int, int) {
        return std::pow(10, deepest) * (random.uniform() < 0.2 ? std::pow(10, cliff) : 1) * random.uniform(-1, 1);
    });
    const double fastest = pick(0.0, 1.0, 10.0, 100.0);
    const auto velocity = [&](int i, int j) {
        return fastest * std::sqrt(g * settings.depth_m(i, j)) * random.uniform(-1, 1);
    };
    settings.velocity_x_m_s = field_of(settings.grid, velocity);
    settings.velocity_y_m_s = field_of(settings.grid, velocity);
    return settings;
}

TYPED_TEST(ShallowVolume, RandomWaterOverRandomGround) {
    for (std::uint64_t seed = 0; seed < 300; ++seed)
        this->expect_kept(random_water(seed), 1e9, "seed " + std::to_string(seed), 200);
}

}  // namespace
}  // namespace waterlight::testing
