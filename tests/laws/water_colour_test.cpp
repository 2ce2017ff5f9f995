// The laws of light in colour: what is known of water at each wavelength, and where each lands.
#include "caustics/water_colour.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <cstring>

#include "caustics/kernels/optics.hpp"
#include "caustics/kernels/water_colour.hpp"
#include "caustics/spectral_floor.hpp"
#include "sim/error.hpp"
#include "tests/support/sides.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using namespace test;

using std::numbers::pi;

// Fresh water at 20 degrees: CRC Handbook of Chemistry and Physics, sodium's D line 1.33299, hydrogen's C 1.33115 and F
// 1.33712; sea water of 35 permille: Austin & Halikas (1976), 1.33940 at 589.26 nm.
TEST(WaterColour, TheIndexIsThatOfTheTables) {
    EXPECT_NEAR(f64::water_index(589.3, 20, 0), 1.33299, 1e-4);
    EXPECT_NEAR(f64::water_index(656.3, 20, 0), 1.33115, 1e-4);
    EXPECT_NEAR(f64::water_index(486.1, 20, 0), 1.33712, 1e-4);
    EXPECT_NEAR(f64::water_index(589.26, 20, 35), 1.33940, 2e-4);
    EXPECT_NEAR(f32::water_index(500, 20, 35), f64::water_index(500, 20, 35), 3e-7);
}

TEST(WaterColour, AbsorbsRedAndScattersBlue) {
    EXPECT_DOUBLE_EQ(pure_water_absorption(450), 0.00922);
    EXPECT_DOUBLE_EQ(pure_water_absorption(550), 0.0565);
    EXPECT_DOUBLE_EQ(pure_water_absorption(650), 0.340);
    EXPECT_DOUBLE_EQ(pure_water_absorption(380), 0.01137);
    EXPECT_DOUBLE_EQ(pure_water_absorption(700), 0.624);
    EXPECT_DOUBLE_EQ(pure_water_absorption(418.75), .5 * (0.00442 + 0.00454));
    EXPECT_NEAR(f64::pure_water_scattering(500, 0), 0.00222, 1e-12);
    EXPECT_NEAR(f64::pure_water_scattering(500, 37), 0.00288, 1e-5);
    // Morel's measured 0.0058 at 400 nm of fresh water.
    EXPECT_NEAR(f64::pure_water_scattering(400, 0), 0.0058, 1e-4);
    EXPECT_NEAR(f64::pure_water_scattering(400, 0) / f64::pure_water_scattering(600, 0), std::pow(1.5, 4.32), 1e-9);
}

// Wien: a black body of 5778 K is brightest at 2897.77 um K / 5778 K = 501.5 nm.
TEST(WaterColour, TheSharesAreThoseOfABlackBody) {
    EXPECT_GT(f64::black_body(501.5, 5778), f64::black_body(500.5, 5778));
    EXPECT_GT(f64::black_body(501.5, 5778), f64::black_body(502.5, 5778));
    const std::vector<double> shares = black_body_shares(std::vector<double>{650, 550, 450});
    EXPECT_NEAR(shares[0] + shares[1] + shares[2], 1, 1e-15);
    EXPECT_EQ(black_body_shares(std::vector<double>{550}).front(), 1);
}

FloorSettings settings_for(const Grid& grid, int pixels, double elevation_deg) {
    FloorSettings s;
    s.plan = cover(grid, pixels, pixels * grid.ny / grid.nx);
    s.sun = {elevation_deg, 0, 1000};
    return s;
}

std::vector<Band> bands_of(const std::vector<double>& wavelengths_nm, const WaterState& state) {
    const std::vector<double> shares = black_body_shares(wavelengths_nm);
    std::vector<Band> bands;
    for (std::size_t i = 0; i < shares.size(); ++i)
        bands.push_back({wavelengths_nm[i], shares[i], optics_at(wavelengths_nm[i], state, {})});
    return bands;
}

/// Phase of the first harmonic along x.
double phase(const Field<float>& map) {
    std::complex<double> sum = 0;
    for (int j = 0; j < map.ny(); ++j)
        for (int i = 0; i < map.nx(); ++i)
            sum += static_cast<double>(map(i, j)) * std::polar(1.0, -2 * pi * (i + 0.5) / map.nx());
    return std::arg(sum);
}

TEST(SpectralFloor, BlueAndRedPartByTheDispersionOfWater) {
    constexpr double depth_m = 5, wavelength_m = .5;
    const Grid grid = make_grid(256, 16, wavelength_m, wavelength_m / 16);
    FloorSettings s = settings_for(grid, 256, 45);
    s.depth_m = depth_m;
    for (const WaterState state : {WaterState{20, 0}, {20, 35}, {10, 35}}) {
        std::vector<Band> bands = bands_of({650, 450}, state);
        // Absorption along ways of unequal length would turn the pattern too.
        for (Band& band : bands) band.optics.absorption_per_m = band.optics.scattering_per_m = 0;
        SpectralFloor mapper(s, bands, make_floor_cpu);
        FloorMap sum;
        mapper.compute(sample(grid, periodic, sines({{2e-4, wavelength_m, 0}})), sum);
        // Away from the sun, which stands in +x, red goes farther.
        const double turned = phase(mapper.maps()[0].map.irradiance) - phase(mapper.maps()[1].map.irradiance);
        const double apart_m = turned / (2 * pi) * wavelength_m;
        EXPECT_NEAR(apart_m / depth_m, 0.0052, .05 * 0.0052) << state.salinity_permille;
        std::printf("at %g degrees and %g permille 450 and 650 nm land %.5f D apart\n", state.temperature_c,
                    state.salinity_permille, apart_m / depth_m);
    }
}

TEST(SpectralFloor, OfOneWavelengthIsTheMapOfOneColourBitForBit) {
    const Grid grid = make_grid(64, 64, 1, 1);
    const Surface surface = sample(grid, periodic, egg_crate(.006, 1));
    FloorSettings s = settings_for(grid, 128, 60);
    SpectralFloor mapper(s, bands_of({550}, {20, 0}), make_floor_cpu);
    s.optics = optics_at(550, {20, 0}, {});
    FloorMap one, colour;
    make_floor_cpu(s)->compute(surface, one);
    mapper.compute(surface, colour);
    EXPECT_EQ(std::memcmp(one.irradiance.data(), colour.irradiance.data(), one.irradiance.size() * sizeof(float)), 0);
    EXPECT_EQ(one.ledger.floor_w, colour.ledger.floor_w);
    EXPECT_EQ(one.window, colour.window);
}

TEST(SpectralFloor, EachBandOfFlatWaterIsItsShareLessWhatItsWaterTakes) {
    const Grid grid = make_grid(16, 16, 1, 1);
    FloorSettings s = settings_for(grid, 16, 60);
    s.depth_m = 3;
    const std::vector<Band> bands = bands_of({650, 550, 450}, {20, 0});
    SpectralFloor mapper(s, bands, make_floor_cpu);
    FloorMap sum;
    mapper.compute(sample(grid, periodic, flat), sum);
    double total = 0;
    for (const BandMap& band : mapper.maps()) {
        const WaterOptics& o = band.band.optics;
        const f64::Refraction r = f64::refract_sun(s.sun.direction(), {0, 0}, o.refractive_index, 1);
        const double expected = 1000 * band.band.share * r.incident * r.transmittance *
                                std::exp(-o.extinction_per_m() * s.depth_m * r.path);
        EXPECT_NEAR(band.map.irradiance(7, 5), expected, 1e-3) << band.band.wavelength_nm;
        total += expected;
    }
    EXPECT_NEAR(sum.irradiance(7, 5), total, 2e-3);
    EXPECT_LT(sum.ledger.closure(), 1e-6);
    EXPECT_NEAR(sum.ledger.incident_w, 1000 * std::sin(pi / 3), 1e-2);
}

TEST(SpectralFloor, RefusesSharesThatAreNone) {
    FloorSettings s = settings_for(make_grid(8, 8, 1, 1), 8, 60);
    std::vector<Band> bands = bands_of({650, 450}, {20, 0});
    EXPECT_THROW(SpectralFloor(s, {}, make_floor_cpu), InputError);
    bands[0].share = 0;
    EXPECT_THROW(SpectralFloor(s, bands, make_floor_cpu), InputError);
    bands[0].share = .9;
    EXPECT_THROW(SpectralFloor(s, bands, make_floor_cpu), InputError);
}

}  // namespace
}  // namespace waterlight
