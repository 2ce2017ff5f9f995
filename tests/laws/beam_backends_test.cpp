// The cpu and vulkan back-ends of light in the water, and of reflected light above it, give the same pictures and the
// same fields.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

#include "caustics/beam_renderer_vulkan.hpp"
#include "caustics/kernels/optics.hpp"
#include "sim/error.hpp"
#include "tests/support/gpu_fixture.hpp"
#include "tests/support/sloping_pool.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using namespace test;

/// A pool of 3 x 3 x 2 m from the side, with waves that focus in it.
struct Scene {
    Formula waves = sines({{.008, .75, 0}, {.006, .6, 50}, {.005, .5, 110}});
    Boundary boundary{Side::wall, Side::wall};
    bool reflected = false;
    BeamSettings beams;
    BeamImageSettings image;

    Scene() {
        beams.grid = {24, 20};
        beams.depth_m = 2;
        beams.sun = {70, 40, 1000};
        beams.optics.absorption_per_m = .1;
        beams.optics.scattering_per_m = .05;
        image.camera = {{1.5, -3.2, -.8}, {1.5, 1.5, -1}, 50, {181, 119}};
    }
    Beams made() const {
        Beams b;
        reflected ? make_reflected_beams(beams, surface(), b) : make_beams(beams, surface(), b);
        return b;
    }
    Surface surface() const { return sample(make_grid(96, 96, 3, 3), boundary, waves); }
};

/// What a named scene changes of that.
struct Change {
    const char* name;
    void (*apply)(Scene&);
};

/// Of the beams, and where needed of the camera.
constexpr Change beam_changes[] = {
    {"pool", [](Scene&) {}},
    {"flat", [](Scene& s) { s.waves = flat; }},
    {"low_sun",
     [](Scene& s) {
         s.beams.sun = {20, 200, 1000};
     }},
    {"absorbing_sides",
     [](Scene& s) {
         s.boundary = {Side::absorbing, Side::absorbing};
         s.image.camera = {{1.4, 1.2, -.7}, {3, 2.5, -1}, 60, {140, 100}};
     }},
    {"periodic_sides",
     [](Scene& s) {
         s.boundary = {Side::periodic, Side::periodic};
         s.image.camera = {{1.4, 1.2, -.7}, {3, 2.5, -1}, 60, {140, 100}};
         s.image.range_m = 15;
     }},
    {"mixed_sides",
     [](Scene& s) {
         s.boundary = {Side::periodic, Side::wall};
         s.image.camera = {{1.4, .2, -1.7}, {1.6, 2.5, -.6}, 60, {140, 100}};
         s.image.range_m = 12;
     }},
    {"finer_grid",
     [](Scene& s) {
         s.beams.grid = {96, 80};
     }},

};

/// From near the floor up against the light.
void along_the_light(Scene& s) {
    const glm::dvec3 eye{1.5, 1.4, -1.9};
    const f64::Refraction rest = f64::refract_sun(s.beams.sun.direction(), {0, 0}, 4.0 / 3, 1);
    s.image.camera = {eye, eye + glm::dvec3{-rest.travel, 1}, 40, {120, 90}};
}

/// From above the water down against the light that it reflects.
void along_reflected_light(Scene& s) {
    s.reflected = true;
    s.beams.depth_m = 1;
    const glm::dvec3 eye{1.7, 1.8, .9}, sun = s.beams.sun.direction();
    s.image.camera = mirrored(Camera{eye, eye - glm::dvec3{sun.x, sun.y, -sun.z}, 50, {150, 100}});
}

/// Of the picture alone.
constexpr Change picture_changes[] = {
    {"inside_the_pool",
     [](Scene& s) {
         s.image.camera = {{.4, .7, -1.1}, {2.5, 2, -1.3}, 70, {150, 130}};
     }},
    {"looking_up",
     [](Scene& s) {
         s.image.camera = {{1.5, 1.4, -1.9}, {1.5, 1.4, 0}, 80, {120, 120}};
     }},
    {"towards_the_sun",
     [](Scene& s) {
         s.image.camera = {{1.1, 1.2, -1.8}, {1.46, 1.5, 0}, 40, {120, 90}};
     }},
    {"along_the_light", along_the_light},
    {"along_the_light_in_samples",
     [](Scene& s) {
         along_the_light(s);
         s.image.samples = 8;
     }},
    {"along_the_light_on_a_fine_grid",
     [](Scene& s) {
         along_the_light(s);
         s.beams.grid = {240, 200};
     }},
    {"along_reflected_light", along_reflected_light},
    {"along_reflected_light_in_samples",
     [](Scene& s) {
         along_reflected_light(s);
         s.image.samples = 8;
     }},
    {"along_reflected_light_on_a_fine_grid",
     [](Scene& s) {
         along_reflected_light(s);
         s.beams.grid = {240, 200};
     }},
    {"samples", [](Scene& s) { s.image.samples = 4; }},
    {"fewer_rays", [](Scene& s) { s.image.reduction = 3; }},
    {"fournier_forand", [](Scene& s) { s.beams.optics.phase.type = Phase::Type::fournier_forand; }},
    {"pure_water",
     [](Scene& s) {
         s.beams.optics.phase.type = Phase::Type::pure_water;
         s.image.samples = 2;
     }},
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

class BeamBackends : public GpuTest {};
class BeamBackendsPicture : public BeamBackends, public testing::WithParamInterface<Change> {};
class BeamBackendsFields : public BeamBackends, public testing::WithParamInterface<Change> {};

TEST_P(BeamBackendsPicture, AreTheSame) {
    Scene s;
    GetParam().apply(s);
    s.image.optics = s.beams.optics;
    const Beams beams = s.made();
    BeamImage cpu, vulkan;
    draw_beams(s.image, beams, cpu);
    make_beam_renderer_vulkan(context)->draw(s.image, beams, vulkan);
    const double error = relative_rmse(vulkan.radiance, cpu.radiance);
    RecordProperty("relative_rmse", std::to_string(error));
    EXPECT_LT(error, 2e-4);
    EXPECT_GT(cpu.counts.beams, 0);
    EXPECT_EQ(vulkan.counts.beams, cpu.counts.beams);
    EXPECT_NEAR(static_cast<double>(vulkan.counts.covered_pixels), static_cast<double>(cpu.counts.covered_pixels),
                5e-3 * static_cast<double>(cpu.counts.covered_pixels));
}

void expect_same(const BeamVolume& vulkan, const BeamVolume& cpu) {
    EXPECT_LT(relative_rmse(vulkan.plane_irradiance, cpu.plane_irradiance), 1e-4);
    EXPECT_LT(relative_rmse(vulkan.scalar_irradiance, cpu.scalar_irradiance), 1e-4);
    ASSERT_EQ(vulkan.ledger.size(), cpu.ledger.size());
    for (std::size_t k = 0; k < cpu.ledger.size(); ++k) {
        const SliceLedger &a = vulkan.ledger[k], &b = cpu.ledger[k];
        const double tolerance = 1e-6 * b.flux_w;
        EXPECT_NEAR(a.flux_w, b.flux_w, tolerance) << k;
        EXPECT_NEAR(a.inside_w, b.inside_w, 10 * tolerance) << k;
        EXPECT_NEAR(a.outside_w, b.outside_w, 10 * tolerance) << k;
        EXPECT_NEAR(a.inside_w + a.outside_w, a.flux_w, 1e-12 * a.flux_w) << "no light is lost in slice " << k;
    }
}

TEST_P(BeamBackendsFields, AreTheSame) {
    Scene s;
    GetParam().apply(s);
    Beams beams;
    make_beams(s.beams, s.surface(), beams);
    const auto renderer = make_beam_renderer_vulkan(context);
    for (const glm::ivec3 cells : {glm::ivec3{30, 22, 13}, {97, 120, 40}, {3, 1, 1}}) {
        BeamVolume cpu, vulkan, again;
        fill_volume(beams, cells, cpu);
        renderer->fill(beams, cells, vulkan);
        RecordProperty("relative_rmse_" + std::to_string(cells.x),
                       std::to_string(relative_rmse(vulkan.plane_irradiance, cpu.plane_irradiance)));
        expect_same(vulkan, cpu);
        renderer->fill(beams, cells, again);
        EXPECT_TRUE(std::ranges::equal(again.plane_irradiance.values(), vulkan.plane_irradiance.values()));
    }
}

INSTANTIATE_TEST_SUITE_P(Beams, BeamBackendsPicture, testing::ValuesIn(beam_changes), name_of);
INSTANTIATE_TEST_SUITE_P(Pictures, BeamBackendsPicture, testing::ValuesIn(picture_changes), name_of);
INSTANTIATE_TEST_SUITE_P(Beams, BeamBackendsFields, testing::ValuesIn(beam_changes), name_of);

// 512 x 512 x 40 cells are 168 MB of sums: more than one band.
TEST_F(BeamBackends, GiveTheSameFieldsInBands) {
    const Scene s;
    Beams beams;
    make_beams(s.beams, s.surface(), beams);
    BeamVolume cpu, vulkan;
    fill_volume(beams, {512, 512, 40}, cpu);
    make_beam_renderer_vulkan(context)->fill(beams, {512, 512, 40}, vulkan);
    expect_same(vulkan, cpu);
}

TEST_F(BeamBackends, GiveTheSameFrameAfterFrame) {
    const auto renderer = make_beam_renderer_vulkan(context);
    EXPECT_EQ(renderer->backend(), "vulkan");
    Scene s;
    for (const double elevation : {80.0, 40.0, -3.0, 60.0}) {
        s.beams.sun.elevation_deg = elevation;
        s.beams.grid = {10 + static_cast<int>(elevation), 17};
        s.image.camera.size = {60, 30 + static_cast<int>(elevation)};
        s.image.optics = s.beams.optics;
        Beams beams;
        make_beams(s.beams, s.surface(), beams);
        BeamImage cpu, vulkan;
        BeamVolume cpu_fields, vulkan_fields;
        draw_beams(s.image, beams, cpu);
        renderer->draw(s.image, beams, vulkan);
        EXPECT_LT(relative_rmse(vulkan.radiance, cpu.radiance), 2e-4);
        fill_volume(beams, {12, 14, 9}, cpu_fields);
        renderer->fill(beams, {12, 14, 9}, vulkan_fields);
        expect_same(vulkan_fields, cpu_fields);
    }
}

TEST_F(BeamBackends, GiveTheSameOnUnevenGround) {
    const auto renderer = make_beam_renderer_vulkan(context);
    const SlopingPool slope{{.2, .1}, -1.9};
    for (const bool rays_too : {false, true}) {
        for (const int samples : {1, 3}) {
            Scene s;
            s.image.optics = s.beams.optics;
            s.image.samples = samples;
            if (rays_too) s.image.ground = slope.ground();
            if (rays_too) s.image.camera = {{.4, .7, -1.1}, {2.5, 2, -1.3}, 70, {150, 130}};
            Beams beams;
            make_beams(s.beams, s.surface(), beams);
            slope.end(beams);
            BeamImage cpu, vulkan;
            draw_beams(s.image, beams, cpu);
            renderer->draw(s.image, beams, vulkan);
            EXPECT_LT(relative_rmse(vulkan.radiance, cpu.radiance), 2e-4);
        }
    }
}

TEST_F(BeamBackends, FieldsEndOnTheGround) {
    // Over a plane each beam's end is one too: light is even above it and nothing below.
    const SlopingPool slope{{.2, .1}, -1.9};
    Scene s;
    s.waves = flat;
    s.beams.sun = {90, 0, 1000};
    Beams beams;
    make_beams(s.beams, s.surface(), beams);
    slope.end(beams);
    BeamVolume volume;
    make_beam_renderer_vulkan(context)->fill(beams, {30, 24, 16}, volume);
    const f64::Refraction f = f64::refract_sun(s.beams.sun.direction(), {0, 0}, 4.0 / 3, 1);
    int lit = 0, dark = 0;
    for (int k = 0; k < 16; ++k) {
        const double z = volume.z_m(k), even = 1000 * f.incident * f.transmittance * std::exp(.15 * z);
        for (int j = 0; j < 24; ++j)
            for (int i = 0; i < 30; ++i) {
                const float e = volume.plane(k)[static_cast<std::size_t>(j * 30 + i)];
                const bool above = slope.height({(i + 1) * .1, (j + 1) * .125}) < z;
                const bool below = slope.height({i * .1, j * .125}) > z;
                if (!above && !below) continue;  // the ground passes through the cell
                EXPECT_NEAR(e / even, above ? 1 : 0, 1e-4) << i << " " << j << " " << k;
                ++(above ? lit : dark);
            }
    }
    EXPECT_GT(lit, 1000);
    EXPECT_GT(dark, 1000);
}

TEST_F(BeamBackends, RefuseSettingsOutOfRange) {
    Scene s;
    s.image.optics = s.beams.optics;
    Beams beams;
    make_beams(s.beams, s.surface(), beams);
    const auto renderer = make_beam_renderer_vulkan(context);
    BeamImage image;
    BeamVolume volume;
    EXPECT_THROW(renderer->fill(beams, {4, 0, 4}, volume), InputError);
    s.image.samples = 0;
    EXPECT_THROW(renderer->draw(s.image, beams, image), InputError);
}

}  // namespace
}  // namespace waterlight
