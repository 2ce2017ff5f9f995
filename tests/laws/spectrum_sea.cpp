// A sea on a grid: its height does not depend on cells or size, and finer grids carry the same waves.
#include <gtest/gtest.h>

#include "sim/airy_dispersion.hpp"
#include "tests/support/airy_runs.hpp"

namespace waterlight::testing {
namespace {

AirySettings sea(int cells, double size, double depth, const SpectrumSettings& spectrum) {
    AirySettings settings = tank(cells, cells, size, size, {}, depth);
    settings.sea = Sea{make_spectrum(spectrum, settings.water), spectrum.seed};
    return settings;
}

TEST(Sea, HeightIsThatOfTheSpectrumOnEveryGrid) {
    // Peak waves of 6.2 m.
    for (const int cells : {128, 256, 512, 1024}) {
        for (const double size : {30.0, 45.0, 60.0}) {
            const auto model = make_airy(sea(cells, size, 50, {SpectrumType::jonswap, 0.2, 2, 3.3, 25, 10, 5}));
            EXPECT_NEAR(4 * std::sqrt(model->diagnostics().variance_m2), 0.2, 0.01 * 0.2)
                << cells << " cells, " << size << " m";
        }
    }
}

TEST(Sea, WhatTheGridCannotCarryIsReported) {
    for (const auto type : {SpectrumType::pierson_moskowitz, SpectrumType::tma}) {
        for (const double size : {8.0, 20.0, 200.0}) {
            const AirySettings settings = sea(96, size, 1.5, {type, 0.2, 2, 3.3, 70, 20, 5});
            const auto model = make_airy(settings);
            const SeaCoverage coverage = model->sea_coverage();
            const double carried = 1 - coverage.longer_fraction - coverage.shorter_fraction;
            // What is shorter than two cells, by direct integration over wave vectors outside the square of the grid's.
            const double edge = pi * 95 / size;
            double shorter = 0;
            for (int n = 0; n < 800; ++n) {
                const double k = edge * std::exp((n + 0.5) * std::log(200.0) / 800), dk = k * std::log(200.0) / 800;
                const double f = airy_omega(k, settings.water) / (2 * pi);
                const double df = airy_group_velocity(k, settings.water) / (2 * pi) * dk;
                for (int m = 0; m < 180; ++m) {
                    const double theta = (m + 0.5) * pi / 90;
                    if (k * std::max(std::abs(std::cos(theta)), std::abs(std::sin(theta))) > edge)
                        shorter += settings.sea->spectrum.density(f, theta) * df * pi / 90;
                }
            }
            EXPECT_NEAR(coverage.shorter_fraction, shorter / coverage.variance_m2, 2e-3);
            EXPECT_NEAR(model->diagnostics().variance_m2 / (carried * coverage.variance_m2), 1, 0.02);
            EXPECT_GT(carried, 0.4);
        }
    }
}

TEST(Sea, LongerWavesThanTheDomainAreLeftOutAndCounted) {
    const AirySettings settings = sea(64, 4.5, 50, {SpectrumType::jonswap, 0.2, 2, 3.3, 0, 10, 5});
    const SeaCoverage coverage = make_airy(settings)->sea_coverage();
    double longer = 0;
    for (int j = 0; j < 400; ++j)
        for (int i = 0; i < 400; ++i) {
            const double cell = 2 * pi / 4.5, kx = ((i + 0.5) / 400 - 0.5) * cell, ky = ((j + 0.5) / 400 - 0.5) * cell;
            const double k = std::hypot(kx, ky), f = airy_omega(k, settings.water) / (2 * pi);
            longer += settings.sea->spectrum.density(f, std::atan2(ky, kx)) * airy_group_velocity(k, settings.water) /
                      (2 * pi * k) * cell * cell / 160000;
        }
    EXPECT_NEAR(coverage.longer_fraction, longer / coverage.variance_m2, 1e-3);
    EXPECT_GT(coverage.longer_fraction, 0.05);
}

TEST(Sea, FinerGridsCarryTheSameLongWaves) {
    const SpectrumSettings spectrum{SpectrumType::jonswap, 0.3, 2, 3.3, 25, 4, 9};
    const auto coarse = make_airy(sea(64, 30, 50, spectrum)), fine = make_airy(sea(256, 30, 50, spectrum));
    const auto other = make_airy(sea(64, 30, 50, {SpectrumType::jonswap, 0.3, 2, 3.3, 25, 4, 10}));
    for (const glm::dvec2 waves : {glm::dvec2{4, 2}, {5, 1}, {-3, 4}, {7, 0}}) {
        const glm::dvec2 k = waves * (2 * pi / 30);
        const auto a = plane_wave_in(coarse->surface(), k), b = plane_wave_in(fine->surface(), k);
        EXPECT_LT(std::abs(a - b), 1e-4 * std::abs(a));
        EXPECT_GT(std::abs(a - plane_wave_in(other->surface(), k)), 0.01 * std::abs(a));
    }
}

TEST(Sea, WavesRunTowardsTheirDirection) {
    const auto model = make_airy(sea(128, 40, 50, {SpectrumType::jonswap, 0.2, 2, 3.3, 30, 40, 5}));
    const glm::dvec2 k = glm::dvec2{6, 3} * (2 * pi / 40);
    Water water;
    water.depth_m = 50;
    const double omega = textbook_omega(std::hypot(k.x, k.y), water);
    const auto before = plane_wave_in(model->surface(), k);
    model->advance(0.5 / omega);
    EXPECT_NEAR(std::arg(before / plane_wave_in(model->surface(), k)), 0.5, 1e-3);
}

}  // namespace
}  // namespace waterlight::testing
