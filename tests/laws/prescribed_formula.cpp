// A surface given by a formula is that formula, on the grid and off it.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "sim/error.hpp"
#include "sim/prescribed.hpp"

namespace waterlight {
namespace {

PrescribedSettings on_pool(int nx, int ny) {
    PrescribedSettings settings;
    settings.grid = make_grid(nx, ny, 3.0, 2.0);
    settings.boundary = {Side::wall, Side::wall};
    settings.water.depth_m = 2;
    return settings;
}

// Largest differences between the grid and the formula: elevation and slope.
glm::dvec2 largest_difference(PrescribedModel& model, double time_s) {
    const Surface& surface = model.surface();
    const Grid& grid = surface.grid;
    glm::dvec2 worst{0, 0};
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            const SurfacePoint exact = model.formula()->at({grid.x_m(i), grid.y_m(j)}, time_s);
            const glm::dvec2 slope{surface.slope_x(i, j), surface.slope_y(i, j)};
            worst.x = std::max(worst.x, std::abs(surface.elevation(i, j) - exact.elevation_m));
            worst.y = std::max(worst.y, glm::length(slope - exact.slope));
        }
    }
    return worst;
}

// How well slope and rate of a formula agree with differences of its elevation.
double derivative_error(const SurfaceFormula& formula, glm::dvec2 at, double t) {
    const double d = 1e-4;
    const SurfacePoint here = formula.at(at, t);
    const auto difference = [&](glm::dvec2 step, double dt) {
        return (formula.at(at + step, t + dt).elevation_m - formula.at(at - step, t - dt).elevation_m) / (2 * d);
    };
    return std::max({std::abs(difference({d, 0}, 0) - here.slope.x), std::abs(difference({0, d}, 0) - here.slope.y),
                     std::abs(difference({0, 0}, d) - here.rate_m_s)});
}

TEST(PrescribedSines, AreTheirFormula) {
    PrescribedSettings settings = on_pool(83, 61);
    settings.slope = {0.02, -0.01};
    settings.sines = {{0.01, 0.5, 20, 30, false}, {0.02, 1.7, -110, 200, true}, {0.005, 0.3, 90, 0, false}};
    const auto model = make_prescribed(settings);
    for (int n = 0; n < 3; ++n) {
        const glm::dvec2 worst = largest_difference(*model, n * 0.37);
        EXPECT_LT(worst.x, 1e-8);
        EXPECT_LT(worst.y, 1e-7);
        model->advance(0.37);
    }
    EXPECT_LT(derivative_error(*model->formula(), {0.7, 0.4}, 1.3), 1e-6);
    EXPECT_EQ(model->surface().tilt, settings.slope);
    EXPECT_EQ(model->steps(), 3);
}

TEST(PrescribedSines, TravelWithTheSpeedOfAiryWavesUnlessFrozen) {
    PrescribedSettings settings = on_pool(8, 8);
    settings.water.surface_tension_n_m = 0;
    settings.sines = {{0.01, 0.8, 0, 0, false}};
    const double k = 2 * std::numbers::pi / 0.8;
    const double speed = std::sqrt(9.81 / k * std::tanh(k * 2));
    const auto moving = make_prescribed(settings);
    settings.sines[0].frozen = true;
    const auto frozen = make_prescribed(settings);
    for (const double t : {0.0, 0.3, 7.7}) {
        EXPECT_NEAR(moving->formula()->at({0.5 + speed * t, 0}, t).elevation_m, 0.01 * std::cos(0.5 * k), 1e-14);
        EXPECT_NEAR(frozen->formula()->at({0.5, 0}, t).elevation_m, 0.01 * std::cos(0.5 * k), 1e-16);
    }
}

TEST(PrescribedTilt, IsAPlane) {
    PrescribedSettings settings = on_pool(12, 9);
    settings.slope = {0.1, 0.05};
    const auto model = make_prescribed(settings);
    const Surface& surface = model->surface();
    for (int j = 0; j < 9; ++j) {
        for (int i = 0; i < 12; ++i) {
            const double plane = 0.1 * surface.grid.x_m(i) + 0.05 * surface.grid.y_m(j);
            EXPECT_NEAR(surface.elevation(i, j), plane, 1e-7);
            EXPECT_FLOAT_EQ(surface.slope_x(i, j), 0.1f);
            EXPECT_FLOAT_EQ(surface.slope_y(i, j), 0.05f);
        }
    }
}

class GerstnerSteepness : public ::testing::TestWithParam<double> {};

TEST_P(GerstnerSteepness, OnTheGridIsItsFormula) {
    PrescribedSettings settings = on_pool(300, 57);
    settings.gerstner = GerstnerSettings{12, {0.4, 3}, GetParam(), 40, 60, 5};
    const auto model = make_prescribed(settings);
    model->advance(12.3);
    const glm::dvec2 worst = largest_difference(*model, 12.3);
    // The sum of amplitudes is below the steepness over the smallest k; slopes near a cusp magnify what is missed.
    const double amplitudes = GetParam() * 3 / (2 * std::numbers::pi);
    const double magnified = std::pow(1 - GetParam(), -3);
    EXPECT_LT(worst.x, 2e-6 * amplitudes * magnified);
    EXPECT_LT(worst.y, 1e-5 * GetParam() * magnified);
    for (const glm::dvec2 at : {glm::dvec2(0.3, 0.2), glm::dvec2(1.9, 1.1), glm::dvec2(2.5, 0.7)}) {
        EXPECT_LT(derivative_error(*model->formula(), at, 4.5), 1e-5 * magnified);
    }
}

INSTANTIATE_TEST_SUITE_P(UpToNearlyBreaking, GerstnerSteepness, ::testing::Values(0.1, 0.4, 0.7, 0.9));

TEST(PrescribedGerstner, FitsPeriodicSidesAndHasNoMean) {
    PrescribedSettings settings = on_pool(240, 160);
    settings.boundary = {Side::periodic, Side::periodic};
    settings.gerstner = GerstnerSettings{16, {0.3, 2}, 0.6, 10, 40, 9};
    const auto model = make_prescribed(settings);
    model->advance(3.3);
    const SurfaceFormula& formula = *model->formula();
    for (const glm::dvec2 at : {glm::dvec2(0.1, 0.2), glm::dvec2(1.9, 1.1)}) {
        const SurfacePoint here = formula.at(at, 3.3);
        EXPECT_NEAR(formula.at(at + glm::dvec2(3, 0), 3.3).elevation_m, here.elevation_m, 1e-12);
        EXPECT_NEAR(formula.at(at + glm::dvec2(0, -2), 3.3).elevation_m, here.elevation_m, 1e-12);
    }
    EXPECT_TRUE(std::isnan(model->diagnostics().energy_j));
}

TEST(PrescribedGerstner, HasNoMeanToTheSecondPowerOfItsSteepness) {
    const auto mean = [](double steepness) {
        PrescribedSettings settings = on_pool(480, 320);
        settings.boundary = {Side::periodic, Side::periodic};
        settings.gerstner = GerstnerSettings{16, {0.3, 2}, steepness, 10, 40, 9};
        const auto model = make_prescribed(settings);
        model->advance(3.3);
        return std::abs(model->diagnostics().volume_m3) / 6;
    };
    EXPECT_LT(mean(0.4), 1e-5);
    EXPECT_NEAR(std::log2(mean(0.4) / mean(0.2)), 3, 0.1);
    EXPECT_NEAR(std::log2(mean(0.8) / mean(0.4)), 3, 0.1);
}

TEST(PrescribedGerstner, IsTheSameForTheSameSeedOnly) {
    PrescribedSettings settings = on_pool(40, 30);
    settings.gerstner = GerstnerSettings{};
    const auto one = make_prescribed(settings);
    const auto same = make_prescribed(settings);
    settings.gerstner->seed = 2;
    const auto other = make_prescribed(settings);
    EXPECT_TRUE(std::ranges::equal(one->surface().elevation.values(), same->surface().elevation.values()));
    EXPECT_FALSE(std::ranges::equal(one->surface().elevation.values(), other->surface().elevation.values()));
}

TEST(PrescribedSettings, OutOfRangeAreRefused) {
    PrescribedSettings settings = on_pool(4, 4);
    for (const double steepness : {1.0, 1.5, -0.1}) {
        settings.gerstner = GerstnerSettings{.steepness = steepness};
        EXPECT_THROW(make_prescribed(settings), InputError) << steepness;
    }
    settings.gerstner = GerstnerSettings{.waves = 0};
    EXPECT_THROW(make_prescribed(settings), InputError);
    settings.gerstner.reset();
    settings.sines = {{0.01, 0}};
    EXPECT_THROW(make_prescribed(settings), InputError);
}

}  // namespace
}  // namespace waterlight
