// The laws of the sun's disc: what it spreads light by, the closed form of a small wave, and the truth of many suns.
#include "caustics/sun_disc.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <complex>
#include <cstring>

#include "sim/error.hpp"
#include "tests/support/sides.hpp"
#include "tests/support/sun_points.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using namespace test;

using std::numbers::pi;
constexpr double sun_deg = 0.2665;

FloorMap map_of(FloorMapper& mapper, const Surface& surface) {
    FloorMap map;
    mapper.compute(surface, map);
    return map;
}

/// The k-th harmonic along x of a map.
double harmonic(const Field<float>& map, int k) {
    std::complex<double> sum = 0;
    for (int j = 0; j < map.ny(); ++j)
        for (int i = 0; i < map.nx(); ++i)
            sum += static_cast<double>(map(i, j)) * std::polar(1.0, -2 * pi * k * (i + 0.5) / map.nx());
    return std::abs(sum) / static_cast<double>(map.size());
}

TEST(EllipseTaps, AddUpToOneAndHaveTheSpreadOfTheEllipse) {
    for (const Spread spread : {Spread{5, 0, 5}, {9, 3, 4}, {2, -1, 20}, {60, 20, 30}}) {
        const EllipseTaps taps(spread);
        double sum = 0, xx = 0, xy = 0, yy = 0;
        const auto add = [&](int dx, int dy, double w) {
            sum += w;
            xx += w * dx * dx;
            xy += w * dx * dy;
            yy += w * dy * dy;
        };
        for (const EllipseTaps::Row& row : taps.rows()) {
            for (int dx = row.run_begin; dx < row.run_end; ++dx) add(dx, row.dy, taps.full_weight());
            for (std::size_t k = 0; k < row.edge_dx.size(); ++k) add(row.edge_dx[k], row.dy, row.edge_weight[k]);
        }
        EXPECT_NEAR(sum, 1, 1e-6);
        EXPECT_NEAR(xx, spread.xx, 0.02) << spread.xx;
        EXPECT_NEAR(xy, spread.xy, 0.02) << spread.xy;
        EXPECT_NEAR(yy, spread.yy, 0.02) << spread.yy;
    }
}

TEST(EllipseTaps, NarrowerThanAPixelChangeNothing) {
    const EllipseTaps taps({1e-4, 0, 2e-4});
    EXPECT_EQ(taps.reach(), glm::ivec2(0, 0));
    Field<float> from(5, 4), to(5, 4);
    for (std::size_t k = 0; k < from.size(); ++k) from.data()[k] = static_cast<float>(k) * 0.7F;
    convolve(taps, from, to);
    for (std::size_t k = 0; k < from.size(); ++k) EXPECT_FLOAT_EQ(to.data()[k], from.data()[k]);
}

TEST(SunDisc, OverheadItsRadiusIsThatOfTheDesign) {
    FloorSettings s;
    s.plan = cover(make_grid(8, 8, 1, 1), 1000, 1000);
    s.sun.elevation_deg = 90;
    const Spread spread = disc_spread(s, sun_deg);
    EXPECT_NEAR(2 * std::sqrt(spread.xx) * 1e-3, 0.00349, 5e-6);
    EXPECT_NEAR(spread.yy, spread.xx, 1e-9);
}

// A wave too small to focus has one harmonic, which a disc of radius r on the floor multiplies by 2 J1(kr) / (kr).
TEST(SunDisc, MultipliesTheHarmonicsOfASmallWaveByTheBesselFunctionOfTheDisc) {
    const Grid grid = make_grid(256, 8, .5, .015625);
    const Surface surface = sample(grid, periodic, sines({{1e-4, .5, 0}, {1e-5, .125, 0}}));
    FloorSettings s;
    s.plan = cover(grid, 256, 8);
    s.depth_m = 4;
    s.sun = {90, 0, 1};
    const double r = s.depth_m * .25 * pi / 180 * 3 / 4;
    const FloorMap sharp = map_of(*make_floor_cpu(s), surface);
    const FloorMap soft = map_of(*make_sun_disc(s, .25, make_floor_cpu), surface);
    for (const int p : {1, 4}) {
        const double x = 2 * pi * p / .5 * r, expected = 2 * std::cyl_bessel_j(1.0, x) / x;
        EXPECT_NEAR(harmonic(soft.irradiance, p) / harmonic(sharp.irradiance, p), expected, 1e-3) << p;
    }
}

/// The truth as a back-end, so that what is measured is the disc alone.
class TruthMapper final : public FloorMapper {
  public:
    TruthMapper(TruthSettings settings, const TruthSurface& surface)
        : settings_(std::move(settings)), surface_(surface) {}
    std::string_view backend() const override { return "truth"; }
    void compute(const Surface&, FloorMap& map) override {
        const TruthMap truth = truth_map(settings_, surface_);
        map.irradiance = Field<float>(truth.irradiance.nx(), truth.irradiance.ny());
        std::copy_n(truth.irradiance.data(), truth.irradiance.size(), map.irradiance.data());
        map.ledger = truth.ledger;
    }

  private:
    TruthSettings settings_;
    const TruthSurface& surface_;
};

FloorMaker truth_maker(const TruthSettings& truth, const TruthSurface& surface) {
    return [truth, &surface](const FloorSettings& floor) {
        TruthSettings settings = truth;
        settings.floor = floor;
        return std::make_unique<TruthMapper>(settings, surface);
    };
}

template <class T>
double brightest(const Field<T>& f) {
    return *std::max_element(f.values().begin(), f.values().end());
}

// a = .01 m, wavelength .5 m, n = 4/3, E0 = 1 W/m2: the light about the crest meets at D = 1 / q - a = 2.523 m,
// q = (1 - 1/n) a k^2. In pixels of wavelength / 256, the crest over the edge between two of them.
TEST(SunDisc, CutsThePeakAtTheCuspOfASineAsManySunsDo) {
    const Grid grid = make_grid(1024, 4, .5, .5 / 256);
    const Formula wave = sines({{.01, .5, 0}});
    TruthSettings t;
    t.floor.plan = cover(grid, 256, 1);
    t.floor.depth_m = 2.523;
    t.floor.sun = {90, 0, 1};
    t.subsamples = 8;
    t.most_subsamples = 16;
    const TruthSurface surface = as_truth(grid, periodic, wave);
    EXPECT_NEAR(brightest(truth_map(t, surface).irradiance), 21.04, .01);
    const Field<double> suns = truth_of(sun_chords(sun_deg, 120), t, surface);
    EXPECT_NEAR(brightest(suns), 8.94, .02 * 8.94);
    const FloorMap disc = map_of(*make_sun_disc(t.floor, sun_deg, truth_maker(t, surface)), Surface(grid, periodic));
    EXPECT_NEAR(brightest(disc.irradiance), 8.94, .02 * 8.94);
    EXPECT_LT(relative_rmse(disc.irradiance, suns), .015);
    const FloorMap two_pass = map_of(*make_sun_disc(t.floor, sun_deg, make_floor_cpu), sample(grid, periodic, wave));
    EXPECT_NEAR(brightest(two_pass.irradiance), 8.94, .02 * 8.94);
    std::printf(
        "peak %.3f of many suns, %.3f of the disc, %.3f of the two-pass map's; relative RMSE of the disc %.2g\n",
        brightest(suns), brightest(disc.irradiance), brightest(two_pass.irradiance),
        relative_rmse(disc.irradiance, suns));
}

TEST(SunDisc, OfASlantedSunAndCrossingWavesIsThatOfManySuns) {
    const Grid grid = make_grid(64, 64, .5, .5);
    const Formula waves = sines({{.0006, .25, 0}, {.0015, .5, 90}});
    for (const auto& [elevation, tolerance] : {std::pair{90.0, .005}, {60.0, .01}, {35.0, .02}}) {
        TruthSettings t;
        t.floor.plan = cover(grid, 48, 48);
        t.floor.depth_m = 6;
        t.floor.sun = {elevation, 25, 1};
        t.subsamples = 2;
        t.most_subsamples = 4;
        const TruthSurface surface = as_truth(grid, periodic, waves);
        const Field<double> suns = truth_of(sun_points(t.floor.sun, .4, 100), t, surface);
        const FloorMap disc = map_of(*make_sun_disc(t.floor, .4, truth_maker(t, surface)), Surface(grid, periodic));
        const FloorMap sharp = map_of(*truth_maker(t, surface)(t.floor), Surface(grid, periodic));
        const double error = relative_rmse(disc.irradiance, suns), without = relative_rmse(sharp.irradiance, suns);
        EXPECT_LT(error, tolerance) << elevation;
        EXPECT_GT(without, 5 * error) << elevation << ": the disc must matter";
        std::printf("sun at %g degrees: relative RMSE %.2g, without the disc %.2g\n", elevation, error, without);
    }
}

TEST(SunDisc, LeavesFlatWaterAsItIsAndAccountsForWhatItSpills) {
    const Grid grid = make_grid(64, 48, 4, 3);
    FloorSettings s;
    s.plan = cover(grid, 160, 120);
    s.depth_m = 3;
    s.sun = {50, 30, 1};
    for (const Side side : {Side::periodic, Side::wall, Side::absorbing}) {
        const Surface surface = sample(grid, {side, side}, flat);
        const FloorMap sharp = map_of(*make_floor_cpu(s), surface),
                       soft = map_of(*make_sun_disc(s, 1, make_floor_cpu), surface);
        EXPECT_LT(soft.ledger.closure(), 1e-6);
        EXPECT_NEAR(soft.ledger.incident_w, sharp.ledger.incident_w, 1e-6 * sharp.ledger.incident_w);
        EXPECT_NEAR(soft.irradiance(60, 50), sharp.irradiance(60, 50), 2e-6);
        EXPECT_NEAR(soft.ledger.floor_w, sharp.ledger.floor_w,
                    (side == Side::periodic ? 1e-6 : .02) * sharp.ledger.floor_w);
        EXPECT_GT(soft.ledger.outside_w, -1e-6);
    }
}

TEST(SunDisc, OfAMapInPeriodicWaterIsAPartOfTheWholeMaps) {
    const Grid grid = make_grid(64, 64, 1, 1);
    const Surface surface = sample(grid, periodic, sines({{.006, 1, 0}, {.004, .5, 90}}));
    FloorSettings whole;
    whole.plan = cover(grid, 128, 128);
    whole.footprint = Footprint::pixel;  // what is judged is the disc
    whole.depth_m = 2;
    whole.sun = {60, 25, 1};
    FloorSettings part = whole;
    part.plan.origin_m = {.25, .125};
    part.plan.width = part.plan.height = 64;
    const FloorMap all = map_of(*make_sun_disc(whole, sun_deg, make_floor_cpu), surface);
    const FloorMap some = map_of(*make_sun_disc(part, sun_deg, make_floor_cpu), surface);
    for (int j = 0; j < 64; ++j)
        for (int i = 0; i < 64; ++i) ASSERT_NEAR(some.irradiance(i, j), all.irradiance(i + 32, j + 16), 1e-4);
    EXPECT_LT(some.ledger.closure(), 1e-5);
}

TEST(SunDisc, IsTheSameOnAnyNumberOfThreads) {
    const Grid grid = make_grid(64, 48, 4, 3);
    const Surface surface = sample(grid, {Side::wall, Side::wall}, sines({{.01, 1, 20}}));
    FloorSettings s;
    s.plan = cover(grid, 160, 120);
    const int threads = omp_get_max_threads();
    omp_set_num_threads(1);
    const FloorMap one = map_of(*make_sun_disc(s, 1, make_floor_cpu), surface);
    omp_set_num_threads(3);
    const FloorMap three = map_of(*make_sun_disc(s, 1, make_floor_cpu), surface);
    omp_set_num_threads(threads);
    EXPECT_EQ(std::memcmp(one.irradiance.data(), three.irradiance.data(), one.irradiance.size() * sizeof(float)), 0);
}

TEST(SunDisc, RefusesAHalfAngleOutOfItsRange) {
    FloorSettings s;
    s.plan = cover(make_grid(8, 8, 1, 1), 8, 8);
    for (const double bad : {0.0, -1.0, 11.0, std::nan("")})
        EXPECT_THROW(make_sun_disc(s, bad, make_floor_cpu), InputError);
}

}  // namespace
}  // namespace waterlight
