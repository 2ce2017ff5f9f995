// Water at rest stays at rest, over any ground, at any height, with every source and side at zero strength.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/shallow_runs.hpp"

namespace waterlight::testing {
namespace {

constexpr int rest_steps = 10000;

template <class Real>
class ShallowRest : public ::testing::Test {
  public:
    static constexpr double still_m_s = sizeof(Real) == 4 ? 1e-6 : 1e-12;

    static void expect_rest(const ShallowWaterSettings& settings, const std::string& what) {
        const auto model = make_shallow_water<Real>(settings);
        take_steps(*model, rest_steps);
        EXPECT_LT(fastest_m_s(*model, settings.grid), still_m_s) << what;
    }
};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ShallowRest, Precisions);

/// Water at one level over a ground; what stands above it is dry.
ShallowWaterSettings lake(Field<double> bed, double level_m, const ShallowSides& sides = walled) {
    ShallowWaterSettings settings;
    settings.grid = {bed.nx(), bed.ny(), 1, 1.5, 0, 0};
    settings.sides = sides;
    settings.depth_m = field_of(settings.grid, [&](int i, int j) { return std::max(0.0, level_m - bed(i, j)); });
    settings.bed_m = std::move(bed);
    return settings;
}

constexpr Grid rest_cells{14, 11};

/// Ground from `low` to `high` m above `level_m` at random.
Field<double> rough(double level_m, double low, double high, std::uint64_t seed = 1) {
    RandomStream random(seed, 0);
    return field_of(rest_cells, [&](int, int) { return level_m + random.uniform(low, high); });
}

/// Two islands in water 1 m deep.
Field<double> islands(double level_m) {
    return field_of(rest_cells, [&](int i, int j) {
        return level_m - 1 + 2.3 * std::exp(-0.1 * (std::pow(i - 4.2, 2) + std::pow(j - 4.7, 2))) +
               1.7 * std::exp(-0.3 * (std::pow(i - 10.1, 2) + std::pow(j - 8.4, 2)));
    });
}

/// Every other cell of every other row is a pond of its own level, in a ground of random height above it.
ShallowWaterSettings ponds(double datum_m) {
    RandomStream random(3, 0);
    ShallowWaterSettings settings = lake(rough(datum_m + 5, 0, 4), datum_m);
    for (int j = 1; j < rest_cells.ny; j += 2) {
        for (int i = 1; i < rest_cells.nx; i += 2) {
            settings.depth_m(i, j) = random.uniform(0.01, 3);
            settings.bed_m(i, j) = datum_m + random.uniform(0, 5) - settings.depth_m(i, j);
        }
    }
    return settings;
}

TYPED_TEST(ShallowRest, IslandsAndRandomGround) {
    for (const double level : {0.0, 0.3, -123.4, 10000.0}) {
        this->expect_rest(lake(islands(level), level), "islands at " + std::to_string(level));
        this->expect_rest(lake(rough(level, -2, 1), level), "random ground at " + std::to_string(level));
        this->expect_rest(lake(rough(level, -2, 1), level, periodic_all), "periodic at " + std::to_string(level));
    }
}

TYPED_TEST(ShallowRest, PondsOfOneCellAtLevelsOfTheirOwn) {
    for (const double datum : {0.0, -20.0, 10000.0})
        this->expect_rest(ponds(datum), "ponds at " + std::to_string(datum));
}

/// Shoals of depth d among pits and cliffs `jump` times as deep and as high.
TYPED_TEST(ShallowRest, CliffsUpToAMillionDepths) {
    for (const double depth : {1e-3, 1.0}) {
        for (const double jump : {1.0, 1e3, 1e6}) {
            RandomStream random(4, 0);
            const auto cliffs = field_of(rest_cells, [&](int, int) {
                const double kind = random.uniform();
                return depth * (kind < 0.3 ? -1 : kind < 0.6 ? -1 - jump : jump);
            });
            this->expect_rest(lake(cliffs.clone(), 0),
                              "depth " + std::to_string(depth) + ", jumps of " + std::to_string(jump) + " depths");
        }
    }
}

TYPED_TEST(ShallowRest, SourcesOfNoStrength) {
    ShallowWaterSettings settings = lake(islands(0), 0);
    const double width = settings.grid.width_m(), height = settings.grid.height_m();
    settings.sources = {Drop{{5, 9}, 3, 0, 0}, Drop{{10, 12}, 4, 0, 1}, Rain{0.01, {1, 2}, {0, 0}, 0, 1e30, 1},
                        Wavemaker{{0, 0.9 * height}, {width, 0.9 * height}, 0, 4}};
    settings.manning = 0.03;
    settings.keep_records = true;
    this->expect_rest(settings, "islands");
    ShallowWaterSettings high = ponds(10000);
    high.sources = {Drop{{5, 9}, 3, 0, 0}, Rain{0.01, {1, 2}, {0, 0}, 0, 1e30, 1}};
    high.manning = 0.03;
    this->expect_rest(high, "ponds 10 km up");
}

/// Every kind of side at zero strength against water at `level_m`.
ShallowSides sides_at_rest(double level_m) {
    return {LevelSide{constant_series(level_m)}, FlowSide{level_m, {0, 0}}, DischargeSide{constant_series(0)},
            PistonSide{{{0, 1, 2}, {0.3, 0.3, 0.3}}}};
}

/// Those that know water at level 0 only.
ShallowSides open_sides() {
    return {OpenSide{}, IncidentSide{{{0, 5, 1e9}, {0, 0, 0}}}, IncidentSide{{{0, 1}, {0, 0}}}, OpenSide{}};
}

TYPED_TEST(ShallowRest, SidesOfNoStrength) {
    for (const double level : {0.0, 0.3, 10000.0, 10000.3}) {
        ShallowWaterSettings settings = lake(rough(level, -2, 1), level, sides_at_rest(level));
        settings.manning = 0.03;
        this->expect_rest(settings, "level, flow, river, piston at " + std::to_string(level));
    }
    ShallowWaterSettings settings = lake(rough(0, -2, 1), 0, open_sides());
    settings.manning = 0.03;
    this->expect_rest(settings, "open and incident");
}

TYPED_TEST(ShallowRest, SidesOfNoStrengthOnThinAndDeepWater) {
    for (const double depth : {1e-3, 10.0, 4000.0}) {
        for (const ShallowSides& sides : {sides_at_rest(0), open_sides()})
            this->expect_rest(lake(rough(0, -depth, -depth / 2), 0, sides), std::to_string(depth) + " m");
    }
}

}  // namespace
}  // namespace waterlight::testing
