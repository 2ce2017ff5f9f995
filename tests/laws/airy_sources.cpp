// What drops and wavemakers send out, against integrals that know nothing of the modes.
#include <gtest/gtest.h>
#include <omp.h>

#include <array>

#include "sim/airy_dispersion.hpp"
#include "tests/support/airy_runs.hpp"

namespace waterlight::testing {
namespace {

/// Elevation at distance r and age t of a drop in open water: the Hankel integral of its transform, by Simpson's rule.
double drop_elevation(const Drop& drop, const Water& water, double r, double t) {
    const double radius = drop.radius_m, k_end = 14 / radius;
    const int parts = 4000;
    double sum = 0;
    for (int n = 1; n <= parts; ++n) {
        const double k = k_end * n / parts, q = 0.25 * k * k * radius * radius;
        const double weight = n == parts ? 1 : n % 2 == 1 ? 4 : 2;
        sum += weight * q * std::exp(-q) * std::cos(textbook_omega(k, water) * t) * std::cyl_bessel_j(0, k * r) * k;
    }
    return 0.5 * drop.height_m * radius * radius * sum * k_end / (3 * parts);
}

TEST(Airy, DropSpreadsAsItsHankelIntegral) {
    AirySettings settings = tank(160, 128, 5, 4, {}, 0.3);
    const Drop drop{{2.4, 2.1}, 0.2, 0.01, 0.05};
    settings.sources = {drop};
    const auto model = make_airy(settings);
    model->advance(0.05);
    model->advance(1e-9);
    for (const double age : {1e-9, 0.2, 0.45}) {
        model->advance(0.05 + age - model->surface().time_s);
        const Grid& grid = settings.grid;
        for (int j = 30; j < 100; j += 7)
            for (int i = 40; i < 120; i += 9) {
                const double r = std::hypot(grid.x_m(i) - drop.at_m.x, grid.y_m(j) - drop.at_m.y);
                EXPECT_NEAR(model->surface().elevation(i, j), drop_elevation(drop, settings.water, r, age), 2e-8);
            }
    }
}

TEST(Airy, WallsMirrorADrop) {
    AirySettings settings = tank(160, 128, 5, 4, {Side::wall, Side::wall}, 0.3);
    const Drop drop{{0.3, 3.5}, 0.2, 0.01, 0};
    settings.sources = {drop};
    const auto model = make_airy(settings);
    model->advance(0.5);
    const auto expected = [&](double x, double y) {
        double sum = 0;
        for (const double cx : {0.3, -0.3})
            for (const double cy : {3.5, 4.5})
                sum += drop_elevation(drop, settings.water, std::hypot(x - cx, y - cy), 0.5);
        return sum;
    };
    for (int j = 70; j < 128; j += 6)
        for (int i = 0; i < 60; i += 7)
            EXPECT_NEAR(model->surface().elevation(i, j), expected(settings.grid.x_m(i), settings.grid.y_m(j)), 2e-8);
}

TEST(Airy, ForcedModesFollowTheirSignal) {
    // Each plane-wave mode is an oscillator, its forced motion Duhamel's integral of inflow_signal.
    AirySettings settings = tank(64, 4, 8, 0.5, {}, 0.7);
    const Wavemaker maker{{3, 0}, {3, 0.5}, 0.01, 1.1, 35, 0.4, 1.5};
    settings.sources = {maker};
    const auto model = make_airy(settings);
    const double end = 6.3;
    model->advance(end);
    const double omega = 2 * pi / maker.period_s, wave_number = airy_wave_number(omega, settings.water);
    const Field<double> shape =
        inflow_shape(maker, settings.grid, wave_number, airy_group_velocity(wave_number, settings.water));
    for (const int m : {1, 2, 5, 6, 7, 9}) {
        const double k = 2 * pi * m / 8, w = textbook_omega(k, settings.water);
        double inflow = 0;
        for (int i = 0; i < 64; ++i) inflow += shape(i, 0) * std::cos(k * (settings.grid.x_m(i) - 3)) * 2 / 64;
        const int parts = 200000;
        double motion = 0;
        for (int n = 0; n < parts; ++n) {
            const double t = end * (n + 0.5) / parts;
            motion += inflow_signal(maker, t) * std::cos(w * (end - t)) * end / parts;
        }
        const auto found = plane_wave_in(model->surface(), {k, 0}) * std::polar(1.0, 3 * k);
        EXPECT_NEAR(found.real(), inflow * motion, 1e-7) << "mode " << m;
    }
}

TEST(Airy, WavemakerSendsItsAmplitudeFarAway) {
    constexpr double maker_amplitude = 0.01;
    for (const double period : {0.8, 1.2, 1.8}) {
        AirySettings settings = tank(480, 4, 24, 0.2, {Side::absorbing, Side::periodic}, 0.6);
        settings.sources = {Wavemaker{{12, 0}, {12, 0.2}, maker_amplitude, period, 0, 0, 3}};
        const auto model = make_airy(settings);
        const double speed = airy_group_velocity(airy_wave_number(2 * pi / period, settings.water), settings.water);
        model->advance(24 / speed + 8 * period);
        const std::array<int, 3> probes{60, 150, 400};
        std::array<std::complex<double>, 3> first_harmonic{};
        for (int n = 0; n < 32; ++n) {
            for (std::size_t p = 0; p < probes.size(); ++p)
                first_harmonic[p] += std::polar(2.0 / 32, -2 * pi * n / 32) *
                                     static_cast<double>(model->surface().elevation(probes[p], 1));
            model->advance(period / 32);
        }
        for (const auto& amplitude : first_harmonic)
            EXPECT_NEAR(std::abs(amplitude), maker_amplitude, 0.01 * maker_amplitude) << period << " s";
    }
}

TEST(Airy, ThreadsDoNotChangeABit) {
    const auto run = [](int threads, Boundary boundary) {
        AirySettings settings = tank(90, 70, 3, 2, boundary, 0.4);
        settings.sources = {Rain{5, {0.1, 0.2}, {-0.01, -0.004}, 0, 1e30, 3},
                            Wavemaker{{0.2, 0.3}, {0.9, 1.7}, 0.01, 0.9, 0, 0, 1}};
        const int before = omp_get_max_threads();
        omp_set_num_threads(threads);
        const auto model = make_airy(settings);
        for (int n = 0; n < 10; ++n) model->advance(0.1);
        Field<float> elevation = model->surface().elevation.clone();
        omp_set_num_threads(before);
        return elevation;
    };
    for (const Side x : {Side::periodic, Side::wall, Side::absorbing}) {
        const Boundary boundary{x, Side::absorbing};
        EXPECT_EQ(largest_difference(run(1, boundary), run(3, boundary)), 0);
    }
}

}  // namespace
}  // namespace waterlight::testing
