// A buoy's record as a spectrum: variance, directions, tail.
#include <cmath>
#include <complex>
#include <numbers>

#include "sim/buoy_directions.hpp"
#include "sim/buoy_tail.hpp"
#include "sim/error.hpp"
#include "sim/ndbc_reader.hpp"
#include "sim/spectrum.hpp"
#include "tests/support/ndbc_files.hpp"

namespace waterlight::testing {
namespace {

using std::numbers::pi;
using Buoy = NdbcFiles;

/// Integral of density(theta) exp(i n theta) over the circle.
template <class Density>
std::complex<double> moment(const Density& density, int n) {
    constexpr int parts = 7200;
    std::complex<double> sum = 0;
    for (int i = 0; i < parts; ++i)
        sum += density(2 * pi * i / parts) * std::polar(2 * pi / parts, n * 2 * pi * i / parts);
    return sum;
}

/// m0 by trapezoids of 0.25 mHz.
double integrate(const DirectionalSpectrum& spectrum, double from, double to) {
    const int parts = static_cast<int>((to - from) / 0.00025);
    double sum = 0;
    for (int i = 0; i < parts; ++i) {
        const double f = from + (i + 0.5) * (to - from) / parts;
        sum += moment([&](double theta) { return spectrum.density(f, theta); }, 0).real() * (to - from) / parts;
    }
    return sum;
}

TEST(BuoyDirections, EntropyDistributionHasTheMomentsItIsGiven) {
    for (const double r1 : {0.0, 0.4, 0.85}) {
        for (const double turn : {0.0, 25.0}) {
            const CircularMoments moments = buoy_moments(r1, 200, 0.8 * r1 * r1, 200 + turn);
            const EntropyDistribution distribution(moments);
            EXPECT_NEAR(std::abs(moment(distribution, 0) - 1.0), 0, 1e-9);
            EXPECT_NEAR(std::abs(moment(distribution, 1) - moments.c1), 0, 1e-9);
            EXPECT_NEAR(std::abs(moment(distribution, 2) - moments.c2), 0, 1e-9);
            EXPECT_NEAR(std::abs(moments.c1 - std::polar(r1, (270 - 200.0) * pi / 180)), 0, 1e-12);
        }
    }
}

TEST(BuoyDirections, AreNeverNegativeEvenForMomentsThatCannotBe) {
    for (const double r1 : {0.0, 0.5, 0.99, 1.0})
        for (const double r2 : {0.0, 0.5, 1.0})
            for (const double alpha2 : {0.0, 45.0, 170.0}) {
                const EntropyDistribution distribution(buoy_moments(r1, 10, r2, alpha2));
                for (int i = 0; i < 720; ++i) EXPECT_GT(distribution(i * pi / 360), 0);
                EXPECT_NEAR(moment(distribution, 0).real(), 1, 1e-6);
            }
}

TEST_F(Buoy, VarianceWithoutTailIsThatOfTheBins) {
    write_good();
    const auto spectrum = read_buoy({stem(), "", false, 1}, {});
    // Half of the outer bins, as there is nothing beyond their centres.
    const double m0 = 0.4 * 0.005 + 2 * 0.015 + 1 * 0.02 + 0.1 * 0.01;
    EXPECT_NEAR(spectrum.variance_m2, m0, 1e-12);
    EXPECT_NEAR(integrate(spectrum, 0.1, 0.15), m0, 1e-4 * m0);
    EXPECT_EQ(spectrum.f_max_hz, 0.15);
    EXPECT_EQ(spectrum.density(0.16, 0), 0);
}

TEST_F(Buoy, WavesFromTheWestRunEastAndGapsAreFilled) {
    write_good();
    const auto spectrum = read_buoy({stem(), "", false, 1}, {});
    const auto direction = [&](double f) {
        return std::arg(moment([&](double theta) { return spectrum.density(f, theta); }, 1)) * 180 / pi;
    };
    EXPECT_NEAR(direction(0.1), 0, 1e-6);
    EXPECT_NEAR(direction(0.15), 90, 1e-6);
    // Half way between 0.8 towards east and 0.6 towards north.
    EXPECT_NEAR(direction(0.13), std::atan2(0.6, 0.8) * 180 / pi, 1e-6);
}

TEST_F(Buoy, RecordsWithoutDirectionsOrWavesAreRefused) {
    write_good();
    write(".swr1", "2024 03 05 12 00 999 (0.100) 999 (0.110) 999 (0.130) 999 (0.150)\n");
    EXPECT_THROW(read_buoy({stem(), "", true, 1}, {}), InputError);
    write_good();
    write(".data_spec", "2024 03 05 12 00 0.1 0.0 (0.100) 0.000 (0.110) 0.000 (0.130) 0.000 (0.150)\n");
    EXPECT_THROW(read_buoy({stem(), "", true, 1}, {}), InputError);
}

TEST(BuoyTail, FollowsTobaUntilItMeetsPhillips) {
    // A sea of 2e-3 f^-4, rounded to 0.01, above a peak at 0.2 Hz.
    std::vector<double> f, s;
    for (int i = 0; i < 40; ++i) {
        f.push_back(0.1 + 0.01 * i);
        s.push_back(f.back() < 0.2 ? 0 : std::round(2e-3 * std::pow(f.back(), -4) / 0.01) * 0.01);
    }
    const BuoyTail tail = fit_tail(f, s, {});
    EXPECT_NEAR(tail.beta, 2e-3, 0.02 * 2e-3);
    const double saturation = 0.0081 * 9.81 * 9.81 / std::pow(2 * pi, 4);
    EXPECT_NEAR(tail.density(0.5) * std::pow(0.5, 5), std::min(saturation, 0.5 * tail.beta), 1e-12);
    EXPECT_NEAR(tail.density(3) * std::pow(3, 5), saturation, 1e-12);
    // The slowest wave: 13.5 Hz on clean fresh water.
    EXPECT_NEAR(tail.end_hz, 13.5, 0.1);
    double variance = 0;
    for (int i = 0; i < 200000; ++i) {
        const double step = (tail.end_hz - tail.begin_hz) / 200000;
        variance += tail.density(tail.begin_hz + (i + 0.5) * step) * step;
    }
    EXPECT_NEAR(tail.variance_m2(), variance, 1e-6 * variance);
}

TEST_F(Buoy, TailTakesOverContinuously) {
    write_good();
    const auto spectrum = read_buoy({stem(), "", true, 1}, {});
    const auto at = [&](double f) {
        return moment([&](double theta) { return spectrum.density(f, theta); }, 0).real();
    };
    for (const double f : {0.13, 0.15, 0.17, 0.3}) EXPECT_NEAR(at(f - 1e-7), at(f + 1e-7), 1e-4 * at(f)) << f << " Hz";
    EXPECT_NEAR(integrate(spectrum, 0.1, 3), spectrum.variance_m2, 1e-3 * spectrum.variance_m2);
}

TEST(BuoyData, RealRecordsGiveTheHeightOfTheirBins) {
    const char* data = std::getenv("WATERLIGHT_DATA");
    if (!data) GTEST_SKIP() << "WATERLIGHT_DATA is not set";
    const std::filesystem::path stem = std::filesystem::path(data) / "ndbc" / "41010";
    Water water;
    water.depth_m = 890;
    for (const char* time : {"", "2020-06-01 02:50", "2020-06-05 12:50"}) {
        const NdbcRecord record = read_ndbc(stem, time);
        const auto& f = record.frequency_hz;
        double m0 = 0;
        for (std::size_t i = 0; i < f.size(); ++i) {
            // Bins meet half way; NDBC gives centres to 1 mHz.
            const double low = i == 0 ? f[0] - 0.5 * (f[1] - f[0]) : 0.5 * (f[i - 1] + f[i]);
            const double high = i + 1 == f.size() ? f[i] + 0.5 * (f[i] - f[i - 1]) : 0.5 * (f[i] + f[i + 1]);
            m0 += record.density[i] * (high - low);
        }
        const auto measured = read_buoy({stem, time, false, 1}, water),
                   continued = read_buoy({stem, time, true, 1}, water);
        EXPECT_NEAR(4 * std::sqrt(measured.variance_m2), 4 * std::sqrt(m0), 0.002 * 4 * std::sqrt(m0)) << time;
        EXPECT_GE(continued.variance_m2, 0.99 * m0) << time;
        EXPECT_LE(4 * std::sqrt(continued.variance_m2), 1.06 * 4 * std::sqrt(m0)) << time;
        for (const double hz : {0.1, 0.2, 1.0})
            for (int n = 0; n < 360; ++n) EXPECT_GE(continued.density(hz, n * pi / 180), 0);
    }
}

}  // namespace
}  // namespace waterlight::testing
