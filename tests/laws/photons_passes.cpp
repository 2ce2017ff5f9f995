// Passes of photons that add up, whoever follows them; smoothing, its bias and what it leaves of noise; refusals.
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "caustics/photons/blur.hpp"
#include "caustics/photons/photon_random.hpp"
#include "caustics/truth.hpp"
#include "sim/error.hpp"
#include "tests/support/photon_maps.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using namespace test;
using Start = PhotonOptions::Start;
using Branching = PhotonOptions::Branching;

const Grid unit_square = make_grid(128, 128, 1, 1);
const Formula formula = sines({{.006, .5, 0}, {.004, .5, 90}});

Surface waves() { return sample(unit_square, {}, formula); }

PhotonSettings with_ball(Branching branching) {
    PhotonSettings s = photons_over(unit_square, 32, 32, 60);
    s.floor.objects = objects({{.name = "ball",
                                .shape = Sphere{0.2},
                                .material = {.type = Material::Type::glass, .absorption_per_m = 0.3},
                                .centre_m = {0.5, 0.5, 0}}});
    s.options = {.branching = branching, .map = 100, .passes = 2, .blur_pixels = 1};
    return s;
}

template <class T>
bool same_bytes(const Field<T>& a, const Field<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST(PhotonPasses, AreTheSameBytesForAnyNumberOfThreads) {
    const int threads = omp_get_max_threads();
    for (const Branching branching : {Branching::roulette, Branching::split}) {
        const Surface surface = waves();
        const PhotonSettings s = with_ball(branching);
        omp_set_num_threads(1);
        const PhotonResult one = photon_map(s, surface);
        for (const int many : {2, 5}) {
            omp_set_num_threads(many);
            const PhotonResult other = photon_map(s, surface);
            EXPECT_TRUE(same_bytes(one.map.irradiance, other.map.irradiance)) << many;
            EXPECT_EQ(std::memcmp(&one.map.ledger, &other.map.ledger, sizeof(FloorLedger)), 0);
            EXPECT_EQ(one.error, other.error);
        }
    }
    omp_set_num_threads(threads);
}

PhotonSums copy_of(const PhotonSums& sums) {
    return {sums.passes, sums.power_w.clone(), sums.squares_w2.clone(), sums.ledger};
}

TEST(PhotonPasses, ThreeAndFiveAreEight) {
    const Surface surface = waves();
    PhotonSettings s = with_ball(Branching::split);
    s.options.passes = 8;
    const PhotonResult eight = photon_map(s, surface);
    PhotonSums sums;
    make_photon_floor(s)->add(surface, 3, sums);
    PhotonSums kept = copy_of(sums);
    // Another program goes on with what the first has written down.
    const auto floor = make_photon_floor(s);
    floor->add(surface, 5, kept);
    FloorMap map;
    floor->show(surface, kept, map);
    EXPECT_EQ(floor->passes(), 8);
    EXPECT_EQ(floor->photons(), 8 * 100 * 100);
    EXPECT_TRUE(same_bytes(map.irradiance, eight.map.irradiance));
    EXPECT_EQ(std::memcmp(&map.ledger, &eight.map.ledger, sizeof(FloorLedger)), 0);
    EXPECT_EQ(floor->error_estimate(), eight.error);
    floor->show(surface, sums, map);
    EXPECT_FALSE(same_bytes(map.irradiance, eight.map.irradiance));
}

TEST(PhotonPasses, DrawAnew) {
    // Independent passes: their mean is off by 1 / sqrt(passes).
    const Surface surface = waves();
    PhotonSettings s = photons_over(unit_square, 32, 32, 70);
    const TruthMap truth = truth_map({.floor = s.floor, .tolerance = 2e-4}, as_truth(unit_square, {}, formula));
    s.options.map = 64;
    const double one = relative_rmse(photon_map(s, surface).map.irradiance, truth.irradiance);
    s.options.passes = 16;
    const double many = relative_rmse(photon_map(s, surface).map.irradiance, truth.irradiance);
    EXPECT_NEAR(many / one, 0.25, 0.02);
    s.options.passes = 1;
    s.options.seed = 2;
    const double other = relative_rmse(photon_map(s, surface).map.irradiance, truth.irradiance);
    EXPECT_NE(other, one);
    EXPECT_NEAR(other / one, 1, 0.1);
}

TEST(PhotonPasses, RandomNumbersAreEvenAndDoNotKnowEachOther) {
    const std::uint64_t key = PhotonRandom::key(7, 3);
    constexpr int photons = 1 << 16;
    double first = 0, square = 0, pair = 0, next = 0, last = 0;
    for (int k = 0; k < photons; ++k) {
        PhotonRandom random(key, k);
        const double a = random.next() - 0.5, b = random.next() - 0.5;
        first += a;
        square += a * a;
        pair += a * b;
        next += a * last;
        last = a;
    }
    const double sigma = 1 / std::sqrt(12.0 * photons);
    EXPECT_LT(std::abs(first / photons), 4 * sigma);
    EXPECT_NEAR(square / photons, 1.0 / 12, 4 * std::sqrt(1.0 / 180 / photons));
    EXPECT_LT(std::abs(pair / photons), 4.0 / 12 / std::sqrt(photons));
    EXPECT_LT(std::abs(next / photons), 4.0 / 12 / std::sqrt(photons));
}

double sum_of(const Field<double>& field) {
    double sum = 0;
    for (const double value : field.values()) sum += value;
    return sum;
}

Field<double> noise(int n) {
    Field<double> field(n, n);
    for (std::size_t i = 0; i < field.size(); ++i)
        field.data()[i] = PhotonRandom(1, static_cast<std::int64_t>(i)).next() - 0.5;
    return field;
}

TEST(PhotonBlur, KeepsTheLightAndWhatIsEven) {
    const Field<double> field = noise(37);
    Field<double> even(37, 20);
    even.fill(3);
    for (const bool round : {false, true})
        for (const double sigma : {0.3, 1.0, 5.0, 30.0}) {
            const BlurSettings settings{sigma, round, round};
            EXPECT_NEAR(sum_of(blurred(field, settings)), sum_of(field), 1e-10) << sigma;
            const Field<double> still_even = blurred(even, settings);
            for (const double value : still_even.values()) EXPECT_NEAR(value, 3, 1e-12);
        }
    EXPECT_TRUE(same_bytes(blurred(field, {0, true, true}), field));
}

TEST(PhotonBlur, IsAGaussian) {
    Field<double> point(101, 101);
    point(50, 50) = 1;
    for (const double sigma : {1.0, 2.5, 6.0}) {
        const Field<double> spread = blurred(point, {sigma, false, false});
        for (const int r : {0, 2, 5, 9})
            EXPECT_NEAR(spread(50 + r, 50),
                        std::exp(-r * r / (2 * sigma * sigma)) / (2 * std::numbers::pi * sigma * sigma), 1e-6);
    }
}

TEST(PhotonBlur, LeavesOfWhiteNoiseOneOverTwoRootPiSigma) {
    const Field<double> field = noise(256);
    const auto rms = [](const Field<double>& f) {
        double square = 0;
        for (const double value : f.values()) square += value * value;
        return std::sqrt(square / static_cast<double>(f.size()));
    };
    for (const double sigma : {1.0, 2.0, 4.0}) {
        const double left = rms(blurred(field, {sigma, true, true})) / rms(field);
        EXPECT_NEAR(left, 1 / (2 * std::sqrt(std::numbers::pi) * sigma), 0.05 * left) << sigma;
        EXPECT_NEAR(blur_noise(sigma), 1 / (2 * std::sqrt(std::numbers::pi) * sigma), 1e-3);
    }
}

TEST(PhotonBlur, ItsBiasIsHalfItsVarianceTimesTheLaplacian) {
    PhotonSettings s = photons_over(unit_square, 128, 128, 70);
    const TruthMap truth = truth_map({.floor = s.floor, .tolerance = 2e-4}, as_truth(unit_square, {}, formula));
    double last = 0;
    for (const double sigma : {1.0, 2.0, 4.0}) {
        const BlurSettings settings{sigma, true, true};
        const Field<double> smooth = blurred(truth.irradiance, settings), told = blur_bias(smooth, settings);
        Field<double> bias(128, 128);
        for (std::size_t i = 0; i < bias.size(); ++i) bias.data()[i] = smooth.data()[i] - truth.irradiance.data()[i];
        EXPECT_LT(relative_difference(told, bias), 0.08 * sigma) << "what is of higher order";
        const double size = relative_difference(smooth, truth.irradiance);
        if (last > 0) {
            EXPECT_NEAR(std::log2(size / last), 2, 0.35) << "second order";
        }
        last = size;
    }
}

TEST(PhotonBlur, TradesNoiseForBias) {
    const Surface surface = waves();
    PhotonSettings s = photons_over(unit_square, 128, 128, 70);
    const TruthMap truth = truth_map({.floor = s.floor, .tolerance = 2e-4}, as_truth(unit_square, {}, formula));
    s.options = {.start = Start::surface, .map = 128, .passes = 4};
    const PhotonResult raw = photon_map(s, surface);
    s.options.blur_pixels = 2;
    const PhotonResult smooth = photon_map(s, surface);
    const BlurSettings settings{2, true, true};
    const Field<double> expected = blurred(truth.irradiance, settings);
    // Its own error is that of what it shows: the smoothed truth. Photons in strata are bluer than white noise, and
    // less of theirs is left.
    const double left = relative_rmse(smooth.map.irradiance, expected);
    EXPECT_NEAR(smooth.error / left, 1, 0.15);
    EXPECT_LT(left, blur_noise(2) * raw.error);
    const double bias = relative_difference(expected, truth.irradiance);
    EXPECT_NEAR(relative_rmse(smooth.map.irradiance, truth.irradiance), std::hypot(left, bias), 0.05 * bias);
    EXPECT_NEAR(mean(smooth.map.irradiance), mean(raw.map.irradiance), 1e-4 * mean(raw.map.irradiance));
}

TEST(PhotonSettings, AreRefusedWhereOutOfRange) {
    const auto refused = [](const std::function<void(PhotonSettings&)>& spoil) {
        PhotonSettings s = photons_over(unit_square, 4, 4, 60);
        spoil(s);
        EXPECT_THROW(make_photon_floor(s), InputError);
    };
    refused([](PhotonSettings& s) { s.options.map = 0; });
    refused([](PhotonSettings& s) { s.options.map = 65537; });
    refused([](PhotonSettings& s) { s.options.passes = 0; });
    refused([](PhotonSettings& s) { s.options.bounces = 0; });
    refused([](PhotonSettings& s) { s.options.tolerance = -1; });
    refused([](PhotonSettings& s) { s.options.tolerance = 0.1; });
    refused([](PhotonSettings& s) { s.options.blur_pixels = std::nan(""); });
    refused([](PhotonSettings& s) { s.floor.depth_m = 0; });
    refused([](PhotonSettings& s) { s.lamp = Lamp{.intensity_w_sr = -1}; });
    refused([](PhotonSettings& s) { s.lamp = Lamp{.type = Lamp::Type::spot, .half_angle_deg = 90}; });
    refused([](PhotonSettings& s) { s.lamp = Lamp{.type = Lamp::Type::spot, .at_m = {0, 0, 0}}; });
    refused([](PhotonSettings& s) {
        s.lamp = Lamp{};
        s.options.start = Start::surface;
    });
    PhotonSettings s = photons_over(unit_square, 4, 4, 60);
    s.bed_m = std::make_shared<const Field<float>>(3, 3);
    FloorMap map;
    EXPECT_THROW(make_photon_floor(s)->compute(waves(), map), InputError);
    s.bed_m = nullptr;
    PhotonSums sums;
    EXPECT_THROW(make_photon_floor(s)->show(waves(), sums, map), InputError);
    make_photon_floor(s)->add(waves(), 1, sums);
    s.floor.plan.width = 5;
    EXPECT_THROW(make_photon_floor(s)->add(waves(), 1, sums), InputError);
}

TEST(PhotonSettings, WithoutLightTheMapIsDark) {
    for (const bool lamp : {false, true}) {
        PhotonSettings s = photons_over(unit_square, 4, 4, -5);
        if (lamp) s.lamp = Lamp{.intensity_w_sr = 0};
        const FloorMap map = photon_map(s, waves()).map;
        for (const float e : map.irradiance.values()) EXPECT_EQ(e, 0);
        EXPECT_EQ(map.ledger.incident_w, 0);
    }
}

}  // namespace
}  // namespace waterlight
