// Initial states of the shallow-water model on grids: means over cells, lakes at rest, dams, solitary waves.
#include "sim/shallow_initial.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "sim/error.hpp"
#include "sim/quadrature.hpp"
#include "sim/random.hpp"
#include "sim/shallow_means.hpp"

namespace waterlight::testing {
namespace {

using std::numbers::pi;

double sum_of(const Field<double>& field) {
    double sum = 0;
    for (const double value : field.values()) sum += value;
    return sum;
}

struct Number {
    double value = 0;
    void add(double weight, double x) { value += weight * x; }
};

ShallowWaterSettings over(const Grid& grid, double depth_m) {
    ShallowWaterSettings settings;
    settings.grid = grid;
    settings.water.depth_m = depth_m;
    return settings;
}

TEST(ShallowMeans, RuleIsExactForTheSeventhDegreeAndOfEighthOrder) {
    const auto power = [](int n) { return [n](double x, double y) { return std::pow(x, n) * std::pow(y, n); }; };
    const Rectangle box{0, 0, 2, 3};
    // Its ends are 1e-11 of the width inside.
    EXPECT_NEAR(lobatto_mean<Number>(power(7), box).value / (std::pow(2, 7) / 8 * std::pow(3, 7) / 8), 1, 1e-10);
    EXPECT_GT(std::abs(lobatto_mean<Number>(power(8), box).value / (std::pow(2, 8) / 9 * std::pow(3, 8) / 9) - 1),
              1e-5);

    const auto wave = [](double x, double y) { return std::exp(x) * std::cos(2 * y); };
    const auto error = [&](int n) {
        double sum = 0;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                sum += lobatto_mean<Number>(wave, {2.0 * i / n, 3.0 * j / n, 2.0 / n, 3.0 / n}).value;
        return std::abs(sum / (n * n) - (std::exp(2) - 1) / 2 * std::sin(6) / 6);
    };
    EXPECT_NEAR(std::log2(error(3) / error(6)), 8, 0.2);
}

TEST(ShallowMeans, BowlHoldsItsWaterAtAllTimes) {
    const Grid grid = make_grid(64, 64, 4, 4);
    const double volume = pi * 0.1 / 2;
    for (const double t : {0.0, 0.4, 1.3, 2.9}) {
        for (const ShallowExact& state : {ShallowExact{ThackerPlanar{}}, ShallowExact{ThackerRadial{}}}) {
            const double found = sum_of(cell_means(state, grid, t).depth_m) * grid.cell_area_m2();
            EXPECT_NEAR(found, volume, 1e-6 * volume) << t;
        }
    }
}

TEST(ShallowMeans, VortexLacksTheVolumeOfItsDip) {
    const TravellingVortex state{.centre_m = {0, 0}};
    const Grid grid{48, 48, 0.25, 0.25, -6, -6};
    // The integral of f^2 / 2g over the plane.
    const double dip = 4 / (4 * pi * pi) / (2 * 9.81) * pi * std::exp(1);
    const ShallowMeans means = cell_means(state, grid, 0);
    EXPECT_NEAR((2 * 144 - sum_of(means.depth_m) * grid.cell_area_m2()) / dip, 1, 1e-10);
    EXPECT_NEAR(sum_of(means.discharge_x_m2_s) / sum_of(means.depth_m), 1 / std::sqrt(2), 1e-12);
}

TEST(ShallowMeans, CoarseCellIsTheMeanOfItsQuarters) {
    const Grid coarse{24, 24, 0.25, 0.25, -3, -3}, fine{48, 48, 0.125, 0.125, -3, -3};
    const ShallowMeans a = cell_means(TravellingVortex{}, coarse, 1), b = cell_means(TravellingVortex{}, fine, 1);
    for (int j = 0; j < coarse.ny; ++j) {
        for (int i = 0; i < coarse.nx; ++i) {
            const auto mean = [&](const Field<double>& f) {
                return 0.25 * (f(2 * i, 2 * j) + f(2 * i + 1, 2 * j) + f(2 * i, 2 * j + 1) + f(2 * i + 1, 2 * j + 1));
            };
            EXPECT_NEAR(a.depth_m(i, j), mean(b.depth_m), 1e-12);
            EXPECT_NEAR(a.discharge_x_m2_s(i, j), mean(b.discharge_x_m2_s), 1e-11);
            EXPECT_NEAR(a.discharge_y_m2_s(i, j), mean(b.discharge_y_m2_s), 1e-11);
        }
    }
}

TEST(ShallowMeans, CellsOfShoresAndShocksAreAsRightAsPromised) {
    // A surface that ends at s = 0.3137 of a cell: mean depth = slope (1 - s)^2 / 2, for a circle nearly straight.
    const double cell = 0.01;
    const ThackerPlanar bowl{.eta_m = 0};
    const double shore = 3 - 0.3137 * cell;
    const double depth_far = bowl.exact(3 - cell, 2, 0).depth_m;
    const ShallowMeans at_shore = cell_means(bowl, Grid{1, 1, cell, 1e-6, 3 - cell, 2}, 0);
    double expected = 0;
    for (int n = 0; n < 100000; ++n) expected += bowl.exact(3 - cell + (n + 0.5) * 1e-5 * cell, 2, 0).depth_m * 1e-5;
    EXPECT_NEAR(at_shore.depth_m(0, 0), expected, 1e-5 * depth_far);
    ASSERT_LT(shore, 3);

    const RiemannProblem dam = stoker();
    const double shock = 5 + dam.middle().right_shock_m_s * 2;
    const Grid grid{1, 1, cell, cell, shock - 0.3137 * cell, 0};
    const double behind = dam.middle().depth_m;
    EXPECT_NEAR(cell_means(dam, grid, 2).depth_m(0, 0), 0.3137 * behind + 0.6863 * 0.001, 2e-3 * (behind - 0.001));
}

TEST(ShallowInitial, LakeIsLevelWhateverItsGround) {
    ShallowWaterSettings settings = over(make_grid(37, 23, 5, 3), 1);
    settings.bed_m = Field<double>(37, 23);
    RandomStream random(3, 0);
    for (double& z : settings.bed_m.values()) z = random.uniform() < 0.1 ? 1000 : random.uniform(-2, 1);
    set_initial({StillWater{0.25}}, settings);
    for (std::size_t n = 0; n < settings.grid.cells(); ++n) {
        const double z = settings.bed_m.data()[n];
        EXPECT_EQ(settings.depth_m.data()[n], z < 0.25 ? 0.25 - z : 0);
        EXPECT_EQ(settings.velocity_x_m_s.data()[n], 0);
        EXPECT_EQ(settings.velocity_y_m_s.data()[n], 0);
    }
}

TEST(ShallowInitial, NothingAskedForIsStillWaterAtLevelZero) {
    ShallowWaterSettings settings = over(make_grid(4, 3, 5, 3), 0.7);
    set_initial({}, settings);
    for (const double h : settings.depth_m.values()) EXPECT_EQ(h, 0.7);
}

TEST(ShallowInitial, DamsPartTheirWaterWhereAsked) {
    ShallowWaterSettings settings = over(make_grid(50, 40, 5, 4), 1);
    set_initial({CircularDam{{2.51, 1.97}, 1.2, 1.5, 0.2}}, settings);
    const double added = (sum_of(settings.depth_m) - 1.2 * 2000) * settings.grid.cell_area_m2();
    EXPECT_NEAR(added, 1.3 * pi * 1.44, 1e-3 * 1.3 * pi * 1.44);
    EXPECT_EQ(settings.depth_m(25, 20), 2.5);
    EXPECT_EQ(settings.depth_m(0, 0), 1.2);

    // Along a line through the middle, at any angle, half of the water is behind.
    set_initial({PlaneDam{{2.5, 2}, 67, 1, -1}}, settings);
    EXPECT_NEAR(sum_of(settings.depth_m), 2.0 * 1000, 1e-3 * 2000);
    EXPECT_EQ(settings.depth_m(0, 0), 2);
    EXPECT_EQ(settings.depth_m(49, 39), 0);

    // A dam on the edges of cells leaves none between.
    set_initial({PlaneDam{{2, 0}, 0, 0.5, 0.1}}, settings);
    for (int i = 0; i < 50; ++i) EXPECT_EQ(settings.depth_m(i, 7), i < 20 ? 1.5 : 1.1);
}

TEST(ShallowInitial, SolitaryWaveBringsItsVolumeAndItsDischarge) {
    ShallowWaterSettings settings = over(make_grid(400, 4, 30, 2), 0.32);
    const SolitaryWave wave{{12.3, 0}, 0.064, 0.32, 0};
    set_initial({wave}, settings);
    const double added = (sum_of(settings.depth_m) - 0.32 * 1600) * settings.grid.cell_area_m2();
    EXPECT_NEAR(added, wave.volume_m2() * 2, 1e-9);
    EXPECT_NEAR(wave.volume_m2(), 2 * 0.064 / std::sqrt(3 * 0.064 / (4 * std::pow(0.32, 3))), 1e-14);
    double discharge = 0;
    for (std::size_t n = 0; n < settings.grid.cells(); ++n)
        discharge += settings.depth_m.data()[n] * settings.velocity_x_m_s.data()[n] * settings.grid.cell_area_m2();
    EXPECT_NEAR(discharge, wave.speed_m_s() * added, 1e-9);
    EXPECT_NEAR(wave.speed_m_s(), std::sqrt(9.81 * 0.384), 1e-15);
}

TEST(ShallowInitial, SolitaryWaveKeepsItsFormAndMassGoesWithIt) {
    const SolitaryWave wave{{1, 2}, 0.1, 0.5, 130};
    EXPECT_NEAR(wave.elevation_m(1, 2, 0), 0.1, 1e-16);
    const glm::dvec2 n{std::cos(130 * pi / 180), std::sin(130 * pi / 180)};
    const glm::dvec2 later = glm::dvec2(1, 2) + 3 * wave.speed_m_s() * n;
    EXPECT_NEAR(wave.elevation_m(later.x, later.y, 3), 0.1, 1e-15);
    EXPECT_EQ(wave.elevation_m(1e4, 0, 0), 0);
    // eta_t + div((d + eta) u) = 0, by central differences.
    const auto flux = [&](double x, double y) {
        return (0.5 + wave.elevation_m(x, y, 0)) * wave.velocity_m_s(x, y, 0);
    };
    const double e = 1e-5, x = 1.3, y = 1.8;
    const double change = (wave.elevation_m(x, y, e) - wave.elevation_m(x, y, -e)) / (2 * e);
    const double outflow = (flux(x + e, y).x - flux(x - e, y).x + flux(x, y + e).y - flux(x, y - e).y) / (2 * e);
    EXPECT_NEAR(change, -outflow, 1e-9);
    EXPECT_GT(std::abs(change), 1e-3);
}

TEST(ShallowInitial, SolitaryWaveSparesDryGroundAndRidesOnALake) {
    ShallowWaterSettings settings = over(make_grid(60, 1, 6, 0.1), 1);
    settings.bed_m = Field<double>(60, 1);
    for (int i = 0; i < 60; ++i) settings.bed_m(i, 0) = i < 40 ? -0.5 : 0.3;
    const SolitaryWave wave{{3.9, 0}, 0.1, 0.6, 0};
    set_initial({StillWater{0.1}, wave}, settings);
    EXPECT_NEAR(settings.depth_m(39, 0), 0.7, 1e-3);
    for (int i = 40; i < 60; ++i) {
        EXPECT_EQ(settings.depth_m(i, 0), 0);
        EXPECT_EQ(settings.velocity_x_m_s(i, 0), 0);
    }
}

TEST(ShallowInitial, ExactStatesGiveTheirMeansUnderTheRunsGravity) {
    ShallowWaterSettings settings = over(make_grid(32, 32, 4, 4), 1);
    settings.water.gravity_m_s2 = 5;
    const ThackerPlanar under_five{.gravity_m_s2 = 5};
    settings.bed_m = bed_at_centres(under_five, settings.grid);
    set_initial({ExactStart{ThackerPlanar{}, 0.6}}, settings);
    const ShallowMeans means = cell_means(under_five, settings.grid, 0.6);
    int dry = 0;
    for (std::size_t n = 0; n < settings.grid.cells(); ++n) {
        const double h = settings.depth_m.data()[n];
        EXPECT_EQ(h, means.depth_m.data()[n]);
        EXPECT_NEAR(settings.velocity_x_m_s.data()[n] * h, means.discharge_x_m2_s.data()[n], 1e-16);
        if (h > 0) continue;
        ++dry;
        EXPECT_EQ(settings.velocity_y_m_s.data()[n], 0);
    }
    EXPECT_GT(dry, 500);
    // The velocity is the same everywhere where Thacker's surface is plane.
    const ShallowState middle = under_five.exact(2, 2, 0.6);
    EXPECT_NEAR(settings.velocity_x_m_s(16, 16), middle.velocity_m_s.x, 1e-14);
}

TEST(ShallowInitial, OutOfRangeIsRefused) {
    ShallowWaterSettings settings = over(make_grid(4, 4, 1, 1), 1);
    const double nan = std::nan("");
    for (const ShallowInitial& bad :
         {ShallowInitial{StillWater{nan}}, ShallowInitial{CircularDam{.radius_m = 0}},
          ShallowInitial{PlaneDam{.direction_deg = nan}}, ShallowInitial{SolitaryWave{.height_m = -1}},
          ShallowInitial{SolitaryWave{.depth_m = 0}}, ShallowInitial{ExactStart{ThackerPlanar{.a_m = -1}, 0}},
          ShallowInitial{ExactStart{ThackerPlanar{}, nan}}})
        EXPECT_THROW(set_initial({bad}, settings), InputError);
}

}  // namespace
}  // namespace waterlight::testing
