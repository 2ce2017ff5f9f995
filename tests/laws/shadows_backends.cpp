// The cpu and vulkan back-ends give the same fields and pictures of beams that objects stop.
#include <algorithm>
#include <cmath>
#include <ostream>

#include "caustics/beam_renderer_vulkan.hpp"
#include "sim/bathymetry.hpp"
#include "tests/support/gpu_fixture.hpp"
#include "tests/support/shadow_scenes.hpp"

namespace waterlight {
namespace {

using namespace test;

struct Scene {
    ShadowPool pool;
    BeamImageSettings image;
    Scene() {
        pool.waves = sines({{.008, .75, 0}, {.006, .6, 50}});
        pool.boundary = {Side::wall, Side::wall};
        pool.beams.sun = {60, 40, 1000};
        pool.beams.optics.absorption_per_m = .1;
        pool.beams.optics.scattering_per_m = .05;
        pool.beams.objects =
            objects_of({ball(.3, {1.7, 1.4, -.9}), {.shape = Ring{.2, .25, .2}, .centre_m = {2.6, 1, .6}}});
        image.optics = pool.beams.optics;
        image.camera = {{2, -3.2, -.8}, {2, 1.5, -1}, 50, {181, 119}};
    }
};

struct Change {
    const char* name;
    void (*apply)(Scene&);
};
constexpr Change changes[] = {
    {"pool", [](Scene&) {}},
    {"flat", [](Scene& s) { s.pool.waves = flat; }},
    {"periodic",
     [](Scene& s) {
         s.pool.boundary = {Side::periodic, Side::periodic};
         s.image.camera = {{1, .6, -1.3}, {3, 2.5, -1}, 60, {140, 100}};
         s.image.range_m = 12;
     }},
    {"samples", [](Scene& s) { s.image.samples = 3; }},
    {"fewer_rays", [](Scene& s) { s.image.reduction = 2; }},
    {"on_ground",
     [](Scene& s) {
         Field<float> height(128, 96);
         for (int j = 0; j < 96; ++j)
             for (int i = 0; i < 128; ++i) height(i, j) = -1.8F + .004F * static_cast<float>(i);
         s.pool.beams.ground = std::make_shared<BeamGround>(s.pool.surface().grid, s.pool.boundary, std::move(height));
     }},
    {"reflected",
     [](Scene& s) {
         s.pool.reflected = true;
         s.image.camera = mirrored(Camera{{2, -3.2, .8}, {2, 1.5, .7}, 50, {150, 100}});
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
    return std::sqrt(error / power);
}

class ShadowBackends : public GpuTest, public testing::WithParamInterface<Change> {};

TEST_P(ShadowBackends, GiveTheSameFields) {
    Scene s;
    GetParam().apply(s);
    const Beams beams = s.pool.made();
    ASSERT_TRUE(beams.pieces);
    BeamVolume cpu, vulkan;
    fill_volume(beams, {60, 44, 17}, cpu);
    make_beam_renderer_vulkan(context)->fill(beams, {60, 44, 17}, vulkan);
    RecordProperty("relative_rmse", std::to_string(relative_rmse(vulkan.plane_irradiance, cpu.plane_irradiance)));
    EXPECT_LT(relative_rmse(vulkan.plane_irradiance, cpu.plane_irradiance), 1e-4);
    EXPECT_LT(relative_rmse(vulkan.scalar_irradiance, cpu.scalar_irradiance), 1e-4);
    for (std::size_t k = 0; k < cpu.ledger.size(); ++k) {
        const SliceLedger &a = vulkan.ledger[k], &b = cpu.ledger[k];
        EXPECT_NEAR(a.flux_w, b.flux_w, 2e-6 * b.flux_w) << k;
        EXPECT_NEAR(a.inside_w, b.inside_w, 2e-5 * b.flux_w) << k;
        EXPECT_NEAR(a.outside_w, b.outside_w, 2e-5 * b.flux_w) << k;
        EXPECT_EQ(a.objects_w, b.objects_w) << k;
    }
}

TEST_P(ShadowBackends, GiveTheSamePicture) {
    Scene s;
    GetParam().apply(s);
    s.image.objects = s.pool.beams.objects;
    const Beams beams = s.pool.made();
    BeamImage cpu, vulkan;
    draw_beams(s.image, beams, cpu);
    make_beam_renderer_vulkan(context)->draw(s.image, beams, vulkan);
    const double error = relative_rmse(vulkan.radiance, cpu.radiance);
    RecordProperty("relative_rmse", std::to_string(error));
    EXPECT_LT(error, 2e-4);
    EXPECT_EQ(vulkan.counts.beams, cpu.counts.beams);
    // And the objects are in it.
    s.pool.beams.objects = s.image.objects = nullptr;
    BeamImage bare;
    draw_beams(s.image, s.pool.made(), bare);
    EXPECT_GT(relative_rmse(cpu.radiance, bare.radiance), .02);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShadowBackends, testing::ValuesIn(changes), name_of);

}  // namespace
}  // namespace waterlight
