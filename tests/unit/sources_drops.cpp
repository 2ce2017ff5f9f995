// Drops and rain.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/error.hpp"
#include "sim/kernels/sources.hpp"
#include "sim/sources.hpp"

namespace waterlight {
namespace {

double sum(const Field<double>& field) {
    double total = 0;
    for (const double v : field.values()) total += v;
    return total;
}

TEST(Drop, HasItsProfileAndNoVolume) {
    const Grid grid = make_grid(80, 60, 2.0, 1.5);
    const Drop drop{{1.01, 0.77}, 0.1, 0.02, 0};
    Field<double> eta(grid.nx, grid.ny);
    add_drop(drop, grid, {Side::wall, Side::wall}, eta);
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            const double q = (std::pow(grid.x_m(i) - 1.01, 2) + std::pow(grid.y_m(j) - 0.77, 2)) / 0.01;
            ASSERT_NEAR(eta(i, j), 0.02 * f64::drop_profile(q), 1e-10);
        }
    }
    EXPECT_LT(std::abs(sum(eta)), 1e-15);
}

TEST(Drop, IsMirroredAtAWallAndWrappedAtAPeriodicSide) {
    const Grid grid = make_grid(40, 40, 1.0, 1.0);
    const Grid wide = make_grid(120, 120, 3.0, 3.0);
    const Drop drop{{0.05, 0.96}, 0.12, 0.02, 0};
    for (const Side side : {Side::wall, Side::periodic}) {
        Field<double> eta(grid.nx, grid.ny);
        add_drop(drop, grid, {side, side}, eta);
        // The same on a plane around the domain that holds the nearest images.
        Field<double> plane(wide.nx, wide.ny);
        const auto image = [&](double x, int n) {
            if (side == Side::periodic) return x + n;
            return n == 0 ? x : (n < 0 ? -x : 2 - x);
        };
        for (int n = -1; n <= 1; ++n) {
            for (int m = -1; m <= 1; ++m) {
                const glm::dvec2 at{1 + image(0.05, m), 1 + image(0.96, n)};
                add_drop({at, 0.12, 0.02, 0}, wide, {Side::absorbing, Side::absorbing}, plane);
            }
        }
        for (int j = 0; j < 40; ++j) {
            for (int i = 0; i < 40; ++i) ASSERT_NEAR(eta(i, j), plane(40 + i, 40 + j), 1e-4 * 0.02);
        }
        EXPECT_LT(std::abs(sum(eta)), 1e-15);
    }
}

TEST(Drop, CutOrUnderResolvedStillHasNoVolume) {
    const Grid grid = make_grid(40, 40, 1.0, 1.0);
    for (const double radius : {0.004, 0.02, 0.3, 2.0}) {
        const DropPatch patch = drop_patch({{0.03, 0.5}, radius, 0.02, 0}, grid, {Side::absorbing, Side::periodic});
        EXPECT_LT(std::abs(sum(patch.elevation_m)), 1e-10 * 0.02) << radius;
    }
}

TEST(Drop, OutsideTheDomainReachesNoCell) {
    const Grid grid = make_grid(40, 40, 1.0, 1.0);
    EXPECT_TRUE(drop_patch({{5, 5}, 0.1, 0.02, 0}, grid, {Side::absorbing, Side::absorbing}).elevation_m.empty());
}

TEST(Rain, IsTheSameHoweverTheRunIsDivided) {
    const Grid grid = make_grid(64, 64, 3.0, 2.0);
    const Rain rain{7.5, {0.02, 0.05}, {-0.01, -0.004}, 0.37, 40, 11};
    const std::vector<Drop> whole = drops_of(rain, grid, 0, 60);
    for (const double frame : {0.01, 0.1, 1.0 / 3, 17.0}) {
        std::vector<Drop> parts;
        for (double t = 0; t < 60; t += frame) {
            const auto some = drops_of(rain, grid, t, std::min(t + frame, 60.0));
            parts.insert(parts.end(), some.begin(), some.end());
        }
        ASSERT_EQ(parts.size(), whole.size()) << frame;
        for (std::size_t n = 0; n < whole.size(); ++n) {
            ASSERT_EQ(parts[n].time_s, whole[n].time_s);
            ASSERT_EQ(parts[n].at_m, whole[n].at_m);
            ASSERT_EQ(parts[n].radius_m, whole[n].radius_m);
            ASSERT_EQ(parts[n].height_m, whole[n].height_m);
        }
    }
}

TEST(Rain, IsAPoissonProcess) {
    const Grid grid = make_grid(64, 64, 3.0, 2.0);
    const Rain rain{10, {0.02, 0.05}, {-0.01, -0.004}, 2, 1002, 3};
    const std::vector<Drop> drops = drops_of(rain, grid, 0, 2000);
    // 60 000 drops expected, standard deviation 245.
    EXPECT_NEAR(static_cast<double>(drops.size()), 60000, 5 * 245);
    std::vector<double> counts(1000, 0);
    double mean_x = 0;
    double mean_y = 0;
    for (std::size_t n = 0; n < drops.size(); ++n) {
        const Drop& drop = drops[n];
        ASSERT_GE(drop.time_s, n == 0 ? 2 : drops[n - 1].time_s);
        ASSERT_LT(drop.time_s, 1002);
        ASSERT_TRUE(drop.at_m.x >= 0 && drop.at_m.x < 3 && drop.at_m.y >= 0 && drop.at_m.y < 2);
        ASSERT_TRUE(drop.radius_m >= 0.02 && drop.radius_m <= 0.05);
        ASSERT_TRUE(drop.height_m >= -0.01 && drop.height_m <= -0.004);
        counts[std::min<std::size_t>(999, static_cast<std::size_t>(drop.time_s - 2))] += 1;
        mean_x += drop.at_m.x / static_cast<double>(drops.size());
        mean_y += drop.at_m.y / static_cast<double>(drops.size());
    }
    EXPECT_NEAR(mean_x, 1.5, 5 * 3 / std::sqrt(12.0 * 60000));
    EXPECT_NEAR(mean_y, 1.0, 5 * 2 / std::sqrt(12.0 * 60000));
    // The counts of a second have variance equal to their mean.
    double variance = 0;
    for (const double count : counts) variance += (count - 60) * (count - 60) / 1000;
    EXPECT_NEAR(variance, 60, 5 * 60 * std::sqrt(2.0 / 1000));
}

TEST(Rain, FallsAtTheSamePlacesOnAnyGridOfTheDomain) {
    const Rain rain;
    const auto coarse = drops_of(rain, make_grid(16, 16, 3.0, 2.0), 0, 5);
    const auto fine = drops_of(rain, make_grid(512, 300, 3.0, 2.0), 0, 5);
    ASSERT_EQ(coarse.size(), fine.size());
    for (std::size_t n = 0; n < fine.size(); ++n) ASSERT_EQ(coarse[n].at_m, fine[n].at_m);
}

TEST(Sources, OutOfRangeAreRefused) {
    EXPECT_THROW(require_valid(Drop{{0, 0}, 0, 0.01, 0}), InputError);
    EXPECT_THROW(require_valid(Drop{{0, 0}, 0.1, 0.01, -1}), InputError);
    EXPECT_THROW(require_valid(Rain{.drops_per_m2_s = 0}), InputError);
    EXPECT_THROW(require_valid(Rain{.radius_m = {0.05, 0.02}}), InputError);
    EXPECT_THROW(require_valid(Wavemaker{.from_m = {1, 1}, .to_m = {1, 1}}), InputError);
    EXPECT_THROW(require_valid(Wavemaker{.period_s = 0}), InputError);
    EXPECT_NO_THROW(require_valid(Rain{}));
}

}  // namespace
}  // namespace waterlight
