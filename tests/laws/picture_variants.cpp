// Every kind of scene that passes are made for, from places where a camera should not be: numbers only, none below 0,
// and the validation layer silent.
#include <algorithm>

#include "tests/support/render_scenes.hpp"

namespace waterlight {
namespace {

/// What a scene may bring along.
enum class Part { floor, colours, walls, ground, volume, beams };

class PictureVariants : public GpuTest, public testing::WithParamInterface<Part> {
  protected:
    Surface surface = wavy_surface(Side::wall);
    Scene scene;
    Field<float> map{32, 24}, ground{32, 24};
    WallMaps walls;
    BeamVolume volume;
    BeamImage image;

    void SetUp() override {
        GpuTest::SetUp();
        scene.surface = &surface;
        scene.depth_m = 2;
        scene.optics.absorption_per_m = 0.1;
        scene.optics.scattering_per_m = 0.1;
        scene.floor_plan = cover(surface.grid, map.nx(), map.ny());
        map.fill(500);
        for (int j = 0; j < ground.ny(); ++j)
            for (int i = 0; i < ground.nx(); ++i) ground(i, j) = -2 + 0.1F * static_cast<float>(i);
        image.radiance = Field<float>(20, 15);
        image.radiance.fill(3);
        bring(GetParam());
    }

    void bring(Part part) {
        switch (part) {
            case Part::floor:
                scene.floor = &map;
                break;
            case Part::colours:
                scene.floor_rgb = {&map, &map, &map};
                break;
            case Part::walls:
                scene.wall_settings = {
                    .pixel_m = 0.1, .above_m = 0.1, .depth_m = 2, .sun = scene.sun, .optics = scene.optics};
                light_walls(scene.wall_settings, surface, walls);
                scene.walls = &walls;
                break;
            case Part::ground:
                scene.ground_m = &ground;
                break;
            case Part::volume: {
                BeamSettings settings;
                settings.grid = {16, 12};
                settings.depth_m = scene.depth_m;
                settings.sun = scene.sun;
                settings.optics = scene.optics;
                Beams beams;
                make_beams(settings, surface, beams);
                fill_volume(beams, {8, 6, 4}, volume);
                scene.volume = &volume;
                break;
            }
            case Part::beams:
                scene.beams = &image;
        }
    }
};

TEST_P(PictureVariants, NothingButNumbersFromWhereNoCameraShouldBe) {
    SceneRenderer renderer(context);
    const double level = surface.elevation(16, 12);
    for (const glm::dvec3 eye : {glm::dvec3{4.125, 3.125, 4},
                                 {4.125, 3.125, level},
                                 {4, 3, -2},
                                 {4, 3, -5},
                                 {7.9, 3, 0.3},
                                 {0, 0, 0},
                                 {8, 6, -2},
                                 {-3, 3, -1},
                                 {-1e5, 3, 2},
                                 {4, 3, 1e6}})
        for (const glm::dvec3 towards : {glm::dvec3{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {-1, 0.5, 0.2}})
            for (const int samples : {1, 4}) {
                Look look;
                look.samples = samples;
                renderer.draw(scene, look, camera_at(eye, eye + towards, {24, 17}));
                const Radiance seen = renderer.read_radiance();
                const auto wrong = std::ranges::count_if(seen.rgb, [](float v) { return !std::isfinite(v) || v < 0; });
                EXPECT_EQ(wrong, 0) << "from " << eye.x << ", " << eye.y << ", " << eye.z << " along " << towards.x
                                    << ", " << towards.y << ", " << towards.z;
            }
}

INSTANTIATE_TEST_SUITE_P(Parts, PictureVariants,
                         testing::Values(Part::floor, Part::colours, Part::walls, Part::ground, Part::volume,
                                         Part::beams));

}  // namespace
}  // namespace waterlight
