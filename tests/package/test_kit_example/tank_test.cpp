// Somebody's own tests of a tank of water.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/airy_dispersion.hpp"
#include "sim/error.hpp"
#include "test_kit/gtest.hpp"
#include "test_kit/world.hpp"

namespace {

using namespace waterlight;

TEST(Tank, TheWaveStandsAsItsFormulaSays) {
    World world = World::from(TANK);
    const double k = 2 * std::numbers::pi, omega = airy_omega(k, world.scenario().water);
    world.advance(2.0);
    const auto exact = [&](double x, double) { return 0.01 * std::cos(k * x) * std::cos(omega * world.time_s()); };
    EXPECT_FIELD_NEAR(world.surface().elevation, on(world.grid(), exact), 1e-7);
    EXPECT_LT(l2_error(world.surface().elevation, world.grid(), exact), 1e-7);
    EXPECT_NEAR(world.elevation_at({1.0, 0.5}), exact(1.0, 0.5), 1e-6);
}

TEST(Tank, VolumeAndEnergyStay) {
    World world = World::from(TANK);
    const double volume = world.volume_m3(), energy = world.energy_j();
    for (int step = 0; step < 20; ++step) world.advance(0.1);
    EXPECT_NEAR(volume, 2.0, 1e-9);
    EXPECT_NEAR(world.volume_m3(), volume, 1e-8);
    EXPECT_NEAR(world.energy_j() / energy, 1, 1e-5);
}

TEST(Tank, LightIsNeitherMadeNorLost) {
    World world = World::from(TANK, {"caustics.floor.pixels=[128, 64]"});
    world.advance(0.3);
    EXPECT_EQ(world.floor_map().irradiance.nx(), 128);
    EXPECT_LT(world.floor_map().ledger.closure(), 1e-4);
    const float before = world.floor_map().irradiance(5, 5);
    world.advance(0.1);
    EXPECT_NE(world.floor_map().irradiance(5, 5), before) << "the map follows the water";
}

TEST(Tank, StillWaterIsEvenlyLit) {
    World world = World::from_text(
        "[domain]\nsize_m = [1.0, 1.0]\ncells = [16, 16]\ndepth_m = 2.0\n[caustics.floor]\npixels = [16, 16]\n");
    world.advance(1.0);
    EXPECT_FIELD_NEAR(world.surface().elevation, 0.0, 0.0);
    EXPECT_FIELD_NEAR(world.floor_map().irradiance, 979.592, 1e-2);
}

// The kit itself: what is not near is found out, and where.
TEST(Kit, NamesTheCellThatIsFarthestOff) {
    World world = World::from(TANK);
    const Field<float>& now = world.surface().elevation;
    Field<float> other = now.clone();
    other(7, 3) += 1;
    const auto result = field_near("a", "b", "", now, other, 0.5);
    EXPECT_FALSE(result);
    EXPECT_NE(std::string(result.message()).find("cell (7, 3)"), std::string::npos) << result.message();
    other(9, 4) = std::nanf("");
    EXPECT_FALSE(field_near("a", "b", "", now, other, 10)) << "not a number is not near";
    EXPECT_FALSE(field_near("a", "b", "", now, Field<float>(3, 3), 10)) << "another size";
    EXPECT_TRUE(field_near("a", "b", "", now, now, 0));
}

TEST(Kit, RefusesAsTheProgramDoes) {
    EXPECT_THROW(World::from("missing.toml"), InputError);
    EXPECT_THROW(World::from(TANK, {"domain.detph_m=1"}), InputError);
    EXPECT_THROW(World::from(TANK).advance(-1), InputError);
    World dark = World::from_text("[domain]\nsize_m = [1, 1]\ncells = [8, 8]\ndepth_m = 1\n");
    EXPECT_THROW(dark.floor_map(), InputError);
}

}  // namespace
