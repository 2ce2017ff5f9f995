// The cpu and vulkan back-ends of caustics mapping give the same map, within 1e-4 relative RMSE, and the same ledger,
// within 1e-5 of the light that came in. With the splats' footprints at a focus less than that: their widths are
// differences of where light lands, of which floats keep less.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <random>

#include "caustics/splat/splat_vulkan.hpp"
#include "sim/error.hpp"
#include "tests/support/gpu_fixture.hpp"
#include "tests/support/splat_maps.hpp"

namespace waterlight {
namespace {

using namespace test;

const Grid grid = make_grid(72, 56, 1.8, 1.4);

Formula random_waves() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> one(0, 1);
    std::vector<Sine> all(24);
    for (Sine& sine : all) {
        sine.wavelength_m = 0.15 + 0.6 * one(random);
        sine.amplitude_m = 0.006 * sine.wavelength_m * one(random);
        sine.direction_deg = 360 * one(random);
        sine.phase_deg = 360 * one(random);
        sine.frozen = true;
    }
    return sines(all);
}

// Random waves over a periodic pool under the sun at 60 degrees, map and vertices of unlike resolution.
struct Scene {
    SplatSettings settings = splat_settings(grid, 100, 84, 60);
    Surface surface = sample(grid, {}, random_waves());

    Scene() { settings.options.grid = 130; }
    void bed() {
        Field<float> heights(grid.nx, grid.ny);
        for (int j = 0; j < grid.ny; ++j)
            for (int i = 0; i < grid.nx; ++i)
                heights(i, j) = static_cast<float>(-0.9 + 0.1 * std::sin(7 * grid.x_m(i)) * std::cos(4 * grid.y_m(j)));
        settings.bed_m = std::make_shared<Field<float>>(std::move(heights));
    }
    void object(Material material) {
        settings.options.grid = 60;
        settings.floor.objects = std::make_shared<ObjectSet>(std::vector<Object>{
            {.name = "ball", .shape = Sphere{0.3}, .material = material, .centre_m = {0.9, 0.7, -0.4}}});
    }
};

struct Change {
    const char* name;
    void (*apply)(Scene&);
};

constexpr Change changes[] = {
    {"waves", [](Scene&) {}},
    {"still", [](Scene& s) { s.surface = Surface(grid, {}); }},
    {"fixed", [](Scene& s) { s.settings.options.size = SplatOptions::Size::fixed; }},
    {"by_distance",
     [](Scene& s) {
         s.settings.options.landing = SplatOptions::Landing::distance;
         s.settings.options.iterations = 3;
     }},
    {"low_sun",
     [](Scene& s) {
         s.settings.floor.sun = {18, 200, 1000};
     }},
    {"night", [](Scene& s) { s.settings.floor.sun.elevation_deg = -5; }},
    {"walls",
     [](Scene& s) {
         s.surface.boundary = {Side::wall, Side::wall};
     }},
    {"absorbing",
     [](Scene& s) {
         s.surface.boundary = {Side::absorbing, Side::absorbing};
     }},
    {"mixed_sides",
     [](Scene& s) {
         s.surface.boundary = {Side::wall, Side::periodic};
     }},
    {"turned_map",
     [](Scene& s) {
         s.settings.floor.plan = {90, 110, {0.7, -0.3}, {0.015, 0.013}, 33};
     }},
    {"turned_map_over_walls",
     [](Scene& s) {
         s.surface.boundary = {Side::wall, Side::wall};
         s.settings.floor.plan = {120, 110, {0.7, -0.9}, {0.02, 0.02}, 33};
     }},
    {"tilt",
     [](Scene& s) {
         s.surface = sample(grid, {}, tilted({0.03, -0.02}), {0.03, -0.02});
     }},
    {"murky",
     [](Scene& s) {
         s.settings.floor.optics.absorption_per_m = 0.3;
         s.settings.floor.optics.scattering_per_m = 0.2;
     }},
    {"no_fresnel", [](Scene& s) { s.settings.floor.optics.fresnel = false; }},
    {"hills", [](Scene& s) { s.bed(); }},
    {"hills_between_walls",
     [](Scene& s) {
         s.bed();
         s.surface.boundary = {Side::wall, Side::wall};
     }},
    {"lamp",
     [](Scene& s) {
         s.settings.lamp = Lamp{.at_m = {0.7, 0.8, 2}};
     }},
    {"spot_on_hills",
     [](Scene& s) {
         s.bed();
         s.settings.lamp = Lamp{Lamp::Type::spot, {0.7, 0.8, 2}, 500, {0.9, 0.7, 0}, 15};
     }},
    {"glass", [](Scene& s) { s.object({.type = Material::Type::glass}); }},
    {"mirror_between_walls",
     [](Scene& s) {
         s.object({.type = Material::Type::mirror});
         s.surface.boundary = {Side::wall, Side::wall};
     }},
    {"opaque_under_a_lamp",
     [](Scene& s) {
         s.object({});
         s.settings.lamp = Lamp{.at_m = {0.7, 0.8, 2}};
     }},
};

std::ostream& operator<<(std::ostream& out, const Change& change) { return out << change.name; }

std::string name_of(const testing::TestParamInfo<Change>& change) { return change.param.name; }

double difference(const Field<float>& found, const Field<float>& expected) {
    double error = 0, power = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const double e = expected.values()[i], d = found.values()[i] - e;
        error += d * d;
        power += e * e;
    }
    return error == 0 ? 0 : std::sqrt(error / power);
}

void expect_same(const FloorMap& vulkan, const FloorMap& cpu) {
    ASSERT_EQ(vulkan.irradiance.size(), cpu.irradiance.size());
    EXPECT_LT(difference(vulkan.irradiance, cpu.irradiance), 1e-4);
    const FloorLedger &a = vulkan.ledger, &b = cpu.ledger;
    const double tolerance = 1e-5 * (b.incident_w + b.entered_w);
    EXPECT_NEAR(a.incident_w, b.incident_w, tolerance);
    EXPECT_NEAR(a.reflected_w, b.reflected_w, tolerance);
    EXPECT_NEAR(a.extinguished_w, b.extinguished_w, tolerance);
    EXPECT_NEAR(a.floor_w, b.floor_w, tolerance);
    EXPECT_NEAR(a.outside_w, b.outside_w, tolerance);
    EXPECT_NEAR(a.objects_w, b.objects_w, tolerance);
    EXPECT_NEAR(a.lost_w, b.lost_w, tolerance);
    EXPECT_NEAR(a.entered_w, b.entered_w, tolerance);
    EXPECT_LT(a.closure(), 1e-5);
}

class SplatBackends : public GpuTest, public testing::WithParamInterface<Change> {};

TEST_P(SplatBackends, Agree) {
    Scene s;
    GetParam().apply(s);
    const auto cpu = make_splat_floor_cpu(s.settings), vulkan = make_splat_floor_vulkan(s.settings, context);
    EXPECT_EQ(vulkan->backend(), "vulkan");
    FloorMap a, b;
    cpu->compute(s.surface, a);
    vulkan->compute(s.surface, b);
    expect_same(b, a);
    const SplatReport c = cpu->report(), v = vulkan->report();
    EXPECT_EQ(v.vertices, c.vertices);
    EXPECT_NEAR(static_cast<double>(v.not_converged), static_cast<double>(c.not_converged), 1e-3 * c.vertices);
    EXPECT_NEAR(static_cast<double>(v.missed), static_cast<double>(c.missed), 1e-3 * c.vertices);
    EXPECT_NEAR(v.last_step_m, c.last_step_m, 1e-5 + 1e-2 * c.last_step_m);
    // The same map for the same frame.
    FloorMap again;
    vulkan->compute(s.surface, again);
    EXPECT_EQ(difference(again.irradiance, b.irradiance), 0);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SplatBackends, testing::ValuesIn(changes), name_of);

class SplatVulkan : public GpuTest {};

TEST_F(SplatVulkan, RefusesWhatIsOutOfRangeAndTooManyVertices) {
    Scene s;
    s.settings.options.grid = 1;
    EXPECT_THROW(make_splat_floor_vulkan(s.settings, context), InputError);
    s.settings.options.grid = 16384;
    FloorMap map;
    EXPECT_THROW(make_splat_floor_vulkan(s.settings, context)->compute(s.surface, map), InputError);
}

}  // namespace
}  // namespace waterlight
