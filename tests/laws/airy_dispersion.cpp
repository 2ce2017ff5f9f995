// Waves run at the speed of the full dispersion relation, whatever the step, and slope as their derivative says.
#include <gtest/gtest.h>

#include <limits>

#include "sim/airy_dispersion.hpp"
#include "sim/error.hpp"
#include "tests/support/airy_runs.hpp"

namespace waterlight::testing {
namespace {

TEST(Airy, DispersionHoldsFromLongWavesToRipples) {
    for (const double wavelength : {200.0, 20.0, 2.0, 0.2, 0.0173, 0.003}) {
        for (const double depth : {0.01, 1.0, 1e3}) {
            AirySettings settings = tank(32, 32, 3 * wavelength, 2 * wavelength, {}, depth);
            const double direction = std::atan2(4 * pi / (2 * wavelength), 2 * pi / (3 * wavelength));
            const glm::dvec2 k{2 * pi / (3 * wavelength), 4 * pi / (2 * wavelength)};
            settings.sines = {{0.01 * wavelength, 2 * pi / std::hypot(k.x, k.y), direction * 180 / pi, 25, false}};
            const auto model = make_airy(settings);
            const double omega = textbook_omega(std::hypot(k.x, k.y), settings.water);
            model->advance(0.7 / omega);
            const auto before = plane_wave_in(model->surface(), k);
            model->advance(1.1 / omega);
            const auto after = plane_wave_in(model->surface(), k);
            EXPECT_NEAR(std::abs(after), 0.01 * wavelength, 1e-6 * 0.01 * wavelength);
            EXPECT_NEAR(std::arg(before / after), 1.1, 1e-6) << wavelength << " m over " << depth << " m";
            EXPECT_NEAR(std::arg(after), 25 * pi / 180 - 1.8, 1e-6);
        }
    }
}

TEST(Airy, InfiniteDepthIsTheLimitOfGreatDepth) {
    AirySettings settings = tank(32, 32, 2, 2, {}, std::numeric_limits<double>::infinity());
    settings.sines = {{0.01, 1, 0, 0, false}};
    const auto model = make_airy(settings);
    model->advance(1);
    const double omega = std::sqrt(9.81 * 2 * pi + 7.28e-5 * std::pow(2 * pi, 3));
    EXPECT_NEAR(std::arg(plane_wave_in(model->surface(), {2 * pi, 0}) * std::polar(1.0, omega)), 0, 1e-6);
}

TEST(Airy, WaveNumberInvertsFrequencyAndGroupVelocityIsItsSlope) {
    for (const double depth : {0.1, 5.0, std::numeric_limits<double>::infinity()}) {
        Water water;
        water.depth_m = depth;
        for (const double k : {0.003, 0.5, 30.0, 370.0, 5000.0}) {
            const double omega = airy_omega(k, water), dk = 1e-5 * k;
            EXPECT_NEAR(airy_wave_number(omega, water), k, 1e-12 * k);
            const double slope = (airy_omega(k + dk, water) - airy_omega(k - dk, water)) / (2 * dk);
            EXPECT_NEAR(airy_group_velocity(k, water), slope, 1e-8 * slope);
        }
    }
}

AirySettings stirred(Boundary boundary) {
    AirySettings settings = tank(48, 40, 2.4, 2, boundary, 0.5);
    settings.standing = {{0.01, 2, 4}};
    settings.sources = {Drop{{1.1, 0.7}, 0.2, 0.02, 0.313}, Rain{3, {0.15, 0.25}, {-0.01, -0.004}, 0, 1e30, 7},
                        Wavemaker{{0.8, 0}, {0.8, 2}, 0.01, 0.7, 20, 0.5, 2}};
    return settings;
}

TEST(Airy, OneStepEqualsAThousand) {
    for (const Side side : {Side::periodic, Side::wall}) {
        const auto whole = make_airy(stirred({side, side})), divided = make_airy(stirred({side, side}));
        whole->advance(10);
        for (int n = 0; n < 1000; ++n) divided->advance(0.01);
        EXPECT_LT(largest_difference(whole->surface().elevation, divided->surface().elevation),
                  3e-6 * whole->diagnostics().max_abs_elevation_m);
        EXPECT_LT(largest_difference(whole->surface().slope_y, divided->surface().slope_y),
                  1e-5 * std::sqrt(whole->diagnostics().slope_variance));
    }
}

TEST(Airy, SourcesMoveNoWater) {
    for (const Side side : {Side::periodic, Side::wall}) {
        const auto model = make_airy(stirred({side, side}));
        for (int n = 0; n < 50; ++n) {
            model->advance(0.2);
            const double per_cell =
                sum_of(model->surface().elevation) / static_cast<double>(model->surface().grid.cells());
            EXPECT_LT(std::abs(per_cell), 1e-7 * rms_of(model->surface().elevation));
        }
        EXPECT_GT(rms_of(model->surface().elevation), 1e-3);
    }
}

TEST(Airy, SlopesOfManyWavesAreTheirDerivatives) {
    AirySettings settings = tank(64, 96, 4, 3, {}, 1);
    for (int n = 1; n <= 12; ++n) {
        const glm::dvec2 k{2 * pi / 4 * (n - 5), 2 * pi / 3 * (n % 4)};
        const double length = std::hypot(k.x, k.y);
        if (length > 0)
            settings.sines.push_back({0.01 / n, 2 * pi / length, std::atan2(k.y, k.x) * 180 / pi, 40.0 * n});
    }
    const auto model = make_airy(settings);
    model->advance(123.4);
    const auto expected = [&](double x, double y) {
        SurfacePoint sum;
        for (const Sine& sine : settings.sines) {
            const double omega = textbook_omega(2 * pi / sine.wavelength_m, settings.water);
            const SurfacePoint point = evaluate(sine, omega, {x, y}, 123.4);
            sum.elevation_m += point.elevation_m;
            sum.slope += point.slope;
        }
        return sum;
    };
    const Surface& surface = model->surface();
    EXPECT_LT(
        largest_error(surface.elevation, settings.grid, [&](double x, double y) { return expected(x, y).elevation_m; }),
        5e-8);
    EXPECT_LT(largest_error(surface.slope_x, settings.grid, [&](double x, double y) { return expected(x, y).slope.x; }),
              1e-6);
    EXPECT_LT(largest_error(surface.slope_y, settings.grid, [&](double x, double y) { return expected(x, y).slope.y; }),
              1e-6);
}

TEST(Airy, WhatCannotBeIsRefused) {
    const auto refused = [](auto change) {
        AirySettings settings = tank(32, 32, 2, 2, {}, 1);
        change(settings);
        EXPECT_THROW(make_airy(settings), InputError);
    };
    refused([](AirySettings& s) { s.grid.nx = 0; });
    refused([](AirySettings& s) { s.grid.ny = -3; });
    refused([](AirySettings& s) { s.grid.dx_m = 0; });
    refused([](AirySettings& s) { s.water.depth_m = -1; });
    refused([](AirySettings& s) { s.water.density_kg_m3 = 0; });
    refused([](AirySettings& s) { s.margin_m = -1; });
    refused([](AirySettings& s) { s.standing = {{0.01, 3, 0}}; });
    refused([](AirySettings& s) { s.standing = {{0.01, 200, 0}}; });
    refused([](AirySettings& s) { s.sines = {{0.01, 0.7, 0, 0, false}}; });
    refused([](AirySettings& s) { s.sines = {{0.01, 1, 0, 0, true}}; });
    refused([](AirySettings& s) { s.sines = {{0.01, 0.1, 0, 0, false}}; });
    refused([](AirySettings& s) { s.sources = {Drop{{1, 1}, -0.1, 0.01, 0}}; });
    refused([](AirySettings& s) {
        s.boundary.y = Side::absorbing;
        s.standing = {{0.01, 2, 0}};
    });
    refused([](AirySettings& s) {
        s.boundary.x = Side::wall;
        s.sea = Sea{make_spectrum({}, s.water), 1};
    });
}

}  // namespace
}  // namespace waterlight::testing
