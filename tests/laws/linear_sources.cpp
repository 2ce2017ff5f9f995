// Sources neither make nor lose water, and results depend neither on threads nor on how the run is cut into frames.
#include <gtest/gtest.h>
#include <omp.h>

#include "tests/support/linear_runs.hpp"
#include "tests/support/sides.hpp"

namespace waterlight {
namespace {

using testing::basin;
using testing::sum_of_elevation;

using test::periodic;
using test::walls;

LinearSettings busy_pool(int nx, int ny, Boundary boundary) {
    LinearSettings settings = basin(nx, ny, 2.0, 2.0 * ny / nx, boundary);
    settings.sources = {Drop{{0.02, 0.3}, 0.1, 0.01, 0}, Drop{{1.2, 0.99}, 0.06, -0.01, 0.35},
                        Rain{40, {0.03, 0.06}, {-0.004, -0.002}, 0.1, 1e30, 5},
                        Wavemaker{{0.5, 0}, {0.5, 2.0 * ny / nx}, 0.002, 0.4, 30}};
    return settings;
}

class Volume : public ::testing::TestWithParam<Boundary> {};

TEST_P(Volume, StaysAtRounding) {
    const LinearSettings settings = busy_pool(128, 96, GetParam());
    const auto exact = make_linear<double>(settings);
    const auto single = make_linear<float>(settings);
    for (int n = 0; n < 200; ++n) {
        exact->advance(0.1);
        single->advance(0.1);
    }
    const double cells = static_cast<double>(settings.grid.cells());
    ASSERT_GT(exact->steps(), 2000);
    const double scale = std::sqrt(exact->diagnostics().variance_m2);
    EXPECT_GT(scale, 1e-3);
    EXPECT_LT(std::abs(sum_of_elevation(*exact, settings.grid)) / cells, 1e-13 * scale);
    EXPECT_LT(std::abs(sum_of_elevation(*single, settings.grid)) / cells, 2e-5 * scale);
}

INSTANTIATE_TEST_SUITE_P(Sides, Volume, ::testing::Values(walls, periodic, Boundary{Side::periodic, Side::wall}));

Field<float> surface_with_threads(int threads, const LinearSettings& settings) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    const auto model = make_linear<float>(settings);
    for (const double frame : {0.1, 0.25, 0.017, 0.4}) model->advance(frame);
    Field<float> elevation = model->surface().elevation.clone();
    omp_set_num_threads(before);
    return elevation;
}

TEST(LinearThreads, DoNotChangeASingleBit) {
    for (const Boundary boundary : {walls, periodic, Boundary{Side::absorbing, Side::absorbing}}) {
        const LinearSettings settings = busy_pool(150, 203, boundary);
        const Field<float> one = surface_with_threads(1, settings);
        for (const int threads : {2, 3, 7}) {
            const Field<float> many = surface_with_threads(threads, settings);
            EXPECT_TRUE(std::ranges::equal(one.values(), many.values())) << threads << " threads";
        }
    }
}

TEST(LinearFrames, DoNotChangeWhenDropsFall) {
    // With frames of whole steps the division of the run is invisible, rain included.
    const LinearSettings settings = busy_pool(64, 64, periodic);
    const double dt = make_linear<double>(settings)->step_s();
    const auto whole = make_linear<double>(settings);
    const auto parts = make_linear<double>(settings);
    whole->advance(120 * dt);
    for (int n = 0; n < 40; ++n) parts->advance(3 * dt);
    ASSERT_EQ(whole->steps(), parts->steps());
    const double error = testing::largest_error(*whole, settings.grid, [&](double x, double y) {
        return parts->elevation_m(static_cast<int>(x / settings.grid.dx_m), static_cast<int>(y / settings.grid.dy_m));
    });
    EXPECT_LT(error, 1e-14);
}

// Amplitude of the waves that a maker along y sends through a channel of n cells a metre.
double sent_amplitude(int n) {
    LinearSettings settings = basin(4 * n, 1, 4.0, 1.0 / n, {Side::absorbing, Side::periodic});
    settings.sponge_m = 1.5;
    settings.sources = {Wavemaker{{1, -1}, {1, 1}, 0.01, 0.5}};
    const auto model = make_linear<double>(settings);
    model->advance(6);
    double sum = 0;  // of squares, over two wavelengths and one period
    int count = 0;
    for (int k = 0; k < 20; ++k) {
        model->advance(0.025);
        for (int i = 2 * n; i < 3 * n; ++i, ++count) sum += std::pow(model->elevation_m(i, 0), 2);
    }
    return std::sqrt(2 * sum / count);
}

TEST(LinearWavemaker, SendsTheAmplitudeAskedFor) {
    const double coarse = std::abs(sent_amplitude(32) / 0.01 - 1);
    const double middle = std::abs(sent_amplitude(64) / 0.01 - 1);
    const double fine = std::abs(sent_amplitude(128) / 0.01 - 1);
    EXPECT_LT(fine, 2e-3);
    EXPECT_NEAR(std::log2(coarse / middle), 2, 0.5);
    EXPECT_NEAR(std::log2(middle / fine), 2, 0.5);
}

}  // namespace
}  // namespace waterlight
