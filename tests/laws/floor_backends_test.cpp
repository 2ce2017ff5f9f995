// The cpu and vulkan back-ends of the floor map give the same map, within 1e-4 relative RMSE, and the same ledger,
// within 1e-5 of the light that came in.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "caustics/floor.hpp"
#include "caustics/floor_vulkan.hpp"
#include "sim/error.hpp"
#include "sim/sines.hpp"
#include "tests/support/gpu_fixture.hpp"

namespace waterlight {
namespace {

const Grid grid = make_grid(72, 56, 1.8, 1.4);

Surface surface_of(const std::vector<Sine>& sines, Boundary boundary, glm::dvec2 tilt = {0, 0}) {
    Surface surface(grid, boundary);
    surface.tilt = tilt;
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            const glm::dvec2 at{grid.x_m(i), grid.y_m(j)};
            SurfacePoint sum{glm::dot(tilt, at), tilt, 0};
            for (const Sine& sine : sines) {
                const SurfacePoint point = evaluate(sine, 0, at, 0);
                sum.elevation_m += point.elevation_m;
                sum.slope += point.slope;
            }
            surface.elevation(i, j) = static_cast<float>(sum.elevation_m);
            surface.slope_x(i, j) = static_cast<float>(sum.slope.x);
            surface.slope_y(i, j) = static_cast<float>(sum.slope.y);
        }
    return surface;
}

std::vector<Sine> random_waves() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> one(0, 1);
    std::vector<Sine> sines(24);
    for (Sine& sine : sines) {
        sine.wavelength_m = 0.15 + 0.6 * one(random);
        sine.amplitude_m = 0.006 * sine.wavelength_m * one(random);
        sine.direction_deg = 360 * one(random);
        sine.phase_deg = 360 * one(random);
        sine.frozen = true;
    }
    return sines;
}

// Random waves over a periodic pool under the sun at 60 degrees, map and surface of unlike resolution.
struct Scene {
    FloorSettings settings;
    Surface surface = surface_of(random_waves(), {});

    Scene() {
        settings.footprint = Footprint::pixel;
        settings.plan = cover(grid, 100, 84);
        settings.sun.elevation_deg = 60;
        settings.sun.azimuth_deg = 20;
    }
};

// What a named scene changes of that.
struct Change {
    const char* name;
    void (*apply)(Scene&);
};

constexpr Change changes[] = {
    {"flat", [](Scene& s) { s.surface = Surface(grid, {}); }},
    {"sine",
     [](Scene& s) {
         s.surface = surface_of({{0.01, 0.6, 0, 0, true}}, {});
         s.settings.sun.elevation_deg = 90;
     }},
    {"random_waves", [](Scene&) {}},
    {"slanted_sun",
     [](Scene& s) {
         s.settings.sun.elevation_deg = 18;
         s.settings.sun.azimuth_deg = 200;
     }},
    {"night", [](Scene& s) { s.settings.sun.elevation_deg = -5; }},
    {"turned_map",
     [](Scene& s) {
         s.settings.plan = {90, 110, {0.7, -0.3}, {0.015, 0.013}, 33};
     }},
    {"turned_map_over_walls",
     [](Scene& s) {
         s.surface.boundary = {Side::wall, Side::wall};
         s.settings.plan = {120, 110, {0.7, -0.9}, {0.02, 0.02}, 33};
     }},
    {"finer_map", [](Scene& s) { s.settings.plan = cover(grid, 200, 210); }},
    {"coarser_map", [](Scene& s) { s.settings.plan = cover(grid, 31, 19); }},
    {"walls",
     [](Scene& s) {
         s.surface.boundary = {Side::wall, Side::wall};
     }},
    {"absorbing_sides",
     [](Scene& s) {
         s.surface.boundary = {Side::absorbing, Side::absorbing};
     }},
    {"mixed_sides",
     [](Scene& s) {
         s.surface.boundary = {Side::wall, Side::periodic};
     }},
    {"map_of_a_part",
     [](Scene& s) {
         s.surface.boundary = {Side::absorbing, Side::wall};
         s.settings.plan = {64, 64, {0.5, 0.9}, {0.01, 0.012}, 0};
     }},
    {"tilt",
     [](Scene& s) {
         s.surface = surface_of(random_waves(), {}, {0.03, -0.02});
     }},
    {"murky_water",
     [](Scene& s) {
         s.settings.optics.absorption_per_m = 0.3;
         s.settings.optics.scattering_per_m = 0.2;
     }},
    {"no_fresnel", [](Scene& s) { s.settings.optics.fresnel = false; }},
};

std::ostream& operator<<(std::ostream& out, const Change& change) { return out << change.name; }

std::string name_of(const testing::TestParamInfo<Change>& change) { return change.param.name; }

double relative_rmse(const Field<float>& found, const Field<float>& expected) {
    double error = 0, power = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const double e = expected.values()[i], d = found.values()[i] - e;
        error += d * d;
        power += e * e;
    }
    return error == 0 ? 0 : std::sqrt(error / power);
}

void expect_same(const FloorMap& vulkan, const FloorMap& cpu) {
    ASSERT_EQ(vulkan.window, cpu.window);
    ASSERT_EQ(vulkan.irradiance.nx(), cpu.irradiance.nx());
    ASSERT_EQ(vulkan.irradiance.ny(), cpu.irradiance.ny());
    EXPECT_LT(relative_rmse(vulkan.irradiance, cpu.irradiance), 1e-4);
    const FloorLedger &a = vulkan.ledger, &b = cpu.ledger;
    const double tolerance = 1e-5 * (b.incident_w + b.entered_w);
    EXPECT_NEAR(a.incident_w, b.incident_w, tolerance);
    EXPECT_NEAR(a.reflected_w, b.reflected_w, tolerance);
    EXPECT_NEAR(a.extinguished_w, b.extinguished_w, tolerance);
    EXPECT_NEAR(a.floor_w, b.floor_w, tolerance);
    EXPECT_NEAR(a.outside_w, b.outside_w, tolerance);
    EXPECT_NEAR(a.lost_w, b.lost_w, tolerance);
    EXPECT_NEAR(a.entered_w, b.entered_w, tolerance);
}

class FloorBackends : public GpuTest {
  protected:
    void compare(FloorSettings settings, const Surface& surface, std::optional<FloorWindow> window) {
        settings.window = window;
        FloorMap cpu, vulkan;
        make_floor_cpu(settings)->compute(surface, cpu);
        make_floor_vulkan(settings, context)->compute(surface, vulkan);
        expect_same(vulkan, cpu);
    }
};

class FloorBackendsScene : public FloorBackends, public testing::WithParamInterface<Change> {};

TEST_P(FloorBackendsScene, AgreeThroughEveryWindow) {
    Scene s;
    GetParam().apply(s);
    for (const std::optional<FloorWindow>& window : {std::optional(FloorWindow{1, 1}), std::optional(FloorWindow{7, 7}),
                                                     std::optional(FloorWindow{5, 11}), std::optional<FloorWindow>()}) {
        SCOPED_TRACE(window ? std::to_string(window->samples) + " x " + std::to_string(window->channels) : "auto");
        compare(s.settings, s.surface, window);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, FloorBackendsScene, testing::ValuesIn(changes), name_of);

// 256 x 464 samples with 401 channels are 190 MB: more than one band.
TEST_F(FloorBackends, AgreeWhereTheLatticeIsHandledInBands) {
    Scene s;
    s.settings.plan = cover(grid, 256, 64);
    compare(s.settings, s.surface, FloorWindow{9, 401});
}

TEST_F(FloorBackends, AgreeFrameAfterFrameWhileTheWindowGrowsAndShrinks) {
    FloorSettings settings;
    settings.footprint = Footprint::pixel;
    settings.plan = cover(grid, 80, 60);
    const auto cpu = make_floor_cpu(settings), vulkan = make_floor_vulkan(settings, context);
    EXPECT_EQ(vulkan->backend(), "vulkan");
    FloorMap a, b;
    for (const double amplitude : {0.001, 0.02, 0.0, 0.01}) {
        const Surface surface = surface_of({{amplitude, 0.4, 30, 0, true}}, {Side::wall, Side::absorbing});
        cpu->compute(surface, a);
        vulkan->compute(surface, b);
        expect_same(b, a);
    }
}

TEST_F(FloorBackends, RefuseAWindowWhoseRowOfChannelsCannotBeHeld) {
    FloorSettings settings;
    settings.footprint = Footprint::pixel;
    settings.plan = cover(grid, 4096, 1);
    settings.window = FloorWindow{1, 8193};
    FloorMap map;
    EXPECT_THROW(make_floor_vulkan(settings, context)->compute(Surface(grid, {}), map), InputError);
}

TEST_F(FloorBackends, RefuseSettingsOutOfRange) {
    FloorSettings settings;
    settings.depth_m = -1;
    EXPECT_THROW(make_floor_vulkan(settings, context), InputError);
}

}  // namespace
}  // namespace waterlight
