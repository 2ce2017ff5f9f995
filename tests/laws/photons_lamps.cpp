// Photons of lamps: the inverse square, the power in a cone, the depth that water seems to have.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/photon_maps.hpp"
#include "tests/support/sides.hpp"

namespace waterlight {
namespace {

using namespace test;

PhotonSettings under(const Lamp& lamp, const Grid& grid, double index) {
    PhotonSettings s = photons_over(grid, 32, 32, 90);
    s.lamp = lamp;
    s.floor.optics.refractive_index = index;
    s.options.map = 1024;
    return s;
}

/// I cos / r^2 on the floor, averaged over a pixel.
double falling(const Lamp& lamp, const FloorPlan& plan, double depth, int i, int j) {
    const int parts = 4;
    double sum = 0;
    for (int b = 0; b < parts; ++b)
        for (int a = 0; a < parts; ++a) {
            const glm::dvec2 at = plan.position_m({i + (a + 0.5) / parts, j + (b + 0.5) / parts});
            const glm::dvec3 way = glm::dvec3(at, -depth) - lamp.at_m;
            if (lamp.lights(glm::normalize(way))) sum += lamp.intensity_w_sr * -way.z / std::pow(glm::length(way), 3);
        }
    return sum / (parts * parts);
}

TEST(PhotonLamps, APointSourceFallsWithTheSquareOfItsDistance) {
    const Grid grid = make_grid(4, 4, 4, 4);
    for (const Side side : {Side::wall, Side::absorbing}) {
        const Surface surface(grid, {side, side});
        const Lamp lamp{.at_m = {1, 1.5, 2}, .intensity_w_sr = 100};
        const PhotonSettings s = under(lamp, grid, 1);
        const FloorMap map = photon_map(s, surface).map;
        double difference = 0, square = 0;
        for (int j = 4; j < 28; ++j)
            for (int i = 4; i < 28; ++i) {
                // Walls keep out what would come in below the water.
                const double e = falling(lamp, s.floor.plan, 1, i, j);
                difference += std::pow(map.irradiance(i, j) - e, 2);
                square += e * e;
            }
        EXPECT_LT(std::sqrt(difference / square), 0.01) << int(side);
        EXPECT_LT(map.ledger.closure(), 1e-12);
    }
}

TEST(PhotonLamps, ThroughWaterTheFloorSeemsNearer) {
    const Grid grid = make_grid(4, 4, 1, 1);
    const Lamp lamp{.at_m = {0.5, 0.5, 2}, .intensity_w_sr = 100};
    const PhotonSettings s = under(lamp, grid, 4.0 / 3);
    const FloorMap map = photon_map(s, Surface(grid, open_sides)).map;
    double middle = 0;
    for (int j = 14; j < 18; ++j)
        for (int i = 14; i < 18; ++i) middle += map.irradiance(i, j) / 16;
    const double into_water = 1 - std::pow(1.0 / 7, 2), expected = 100 * into_water / std::pow(2 + 3.0 / 4, 2);
    EXPECT_NEAR(middle, expected, 0.01 * expected);
}

TEST(PhotonLamps, ASpotSendsItsPowerThroughItsCone) {
    const Grid grid = make_grid(4, 4, 4, 4);
    const Surface surface(grid, open_sides);
    const Lamp lamp{.type = Lamp::Type::spot,
                    .at_m = {2.2, 1.8, 2},
                    .intensity_w_sr = 100,
                    .towards_m = {2, 2, -1},
                    .half_angle_deg = 20};
    const PhotonSettings s = under(lamp, grid, 1);
    const FloorMap map = photon_map(s, surface).map;
    EXPECT_NEAR(lamp.power_w(), 100 * 2 * std::numbers::pi * (1 - std::cos(20 * std::numbers::pi / 180)), 1e-9);
    EXPECT_NEAR(map.ledger.incident_w, lamp.power_w(), 1e-9 * lamp.power_w());
    EXPECT_NEAR(map.ledger.floor_w, lamp.power_w(), 1e-9 * lamp.power_w());
    double difference = 0, square = 0, dark = 0;
    for (int j = 0; j < 32; ++j)
        for (int i = 0; i < 32; ++i) {
            const double e = falling(lamp, s.floor.plan, 1, i, j);
            dark += e == 0 ? map.irradiance(i, j) : 0;
            difference += std::pow(map.irradiance(i, j) - e, 2);
            square += e * e;
        }
    EXPECT_LT(dark / 64, 1e-3 * lamp.power_w()) << "beside the cone there is none";
    EXPECT_LT(std::sqrt(difference / square), 0.03) << "pixels on the edge are known to a 16th";
}

TEST(PhotonLamps, UnderWaterALampLightsWhatSnellLetsBack) {
    const Grid grid = make_grid(4, 4, 8, 8);
    const Lamp lamp{.at_m = {4, 4, -0.5}, .intensity_w_sr = 100};
    const PhotonSettings s = under(lamp, grid, 4.0 / 3);
    const FloorMap map = photon_map(s, Surface(grid, open_sides)).map;
    EXPECT_LT(map.ledger.closure(), 1e-12);
    // What leaves the water: 2 pi I times the integral of T over the cosines within the critical angle.
    double out = 0;
    const int parts = 100000;
    for (int k = 0; k < parts; ++k) {
        const double cosine = (k + 0.5) / parts, sine = 4.0 / 3 * std::sqrt(1 - cosine * cosine);
        if (sine >= 1) continue;
        const double n = 3.0 / 4, cosine_out = std::sqrt(1 - sine * sine);
        const double a = cosine + n * cosine_out, b = n * cosine + cosine_out;
        out += 2 * n * cosine * cosine_out * (1 / (a * a) + 1 / (b * b)) / parts;
    }
    const double expected = 100 * 2 * std::numbers::pi * out;
    EXPECT_NEAR(map.ledger.reflected_w, expected, 5e-3 * expected);
}

}  // namespace
}  // namespace waterlight
