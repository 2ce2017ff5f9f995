// A pool without objects looks the same ray traced and drawn by Vulkan.
#include "tests/support/traced_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "caustics/floor.hpp"

namespace waterlight {
namespace {

class TracedAndDrawn : public GpuTest {
  protected:
    struct Difference {
        double mean = 0;    ///< of the mean radiance of the whole picture
        double median = 0;  ///< of pixels, relative to the picture's mean
        double ninety_fifth = 0;
    };

    Difference difference(const Scene& scene, const Look& look, const Camera& camera) {
        SceneRenderer renderer(context);
        Look own = look;
        own.samples = 4;
        renderer.draw(scene, own, camera);
        const Radiance drawn = renderer.read_radiance();
        TracedScene traced;
        traced.scene = scene;
        const TracedPicture picture = trace_picture(traced, look, camera, {.samples = 4});
        const std::vector<double> a = boxes(drawn), b = boxes(picture.radiance);
        double mean_a = 0, mean_b = 0;
        for (std::size_t k = 0; k < a.size(); ++k) {
            mean_a += a[k] / static_cast<double>(a.size());
            mean_b += b[k] / static_cast<double>(a.size());
        }
        std::vector<double> off;
        for (std::size_t k = 0; k < a.size(); ++k) off.push_back(std::abs(a[k] - b[k]) / mean_a);
        std::ranges::sort(off);
        return {std::abs(mean_b / mean_a - 1), off[off.size() / 2], off[off.size() * 95 / 100]};
    }

    /// Means over 4 by 4 pixels: within them the two filter the joints of tiles in their own ways.
    static std::vector<double> boxes(const Radiance& r) {
        const int nx = r.size.x / 4, ny = r.size.y / 4;
        std::vector<double> all(static_cast<std::size_t>(3 * nx * ny));
        for (int j = 0; j < 4 * ny; ++j)
            for (int i = 0; i < 4 * nx; ++i)
                for (int c = 0; c < 3; ++c)
                    all[static_cast<std::size_t>(3 * (j / 4 * nx + i / 4) + c)] += radiance_at(r, i, j)[c] / 16;
        return all;
    }

    Scene pool(const Surface& surface, FloorMap& map) {
        FloorSettings floor;
        floor.plan = cover(surface.grid, 256, 192);
        floor.depth_m = 1.5;
        floor.sun = {50, 30, 1000};
        make_floor_cpu(floor)->compute(surface, map);
        Scene scene;
        scene.surface = &surface;
        scene.depth_m = floor.depth_m;
        scene.floor = &map.irradiance;
        scene.floor_plan = floor.plan;
        scene.sun = floor.sun;
        return scene;
    }
};

TEST_F(TracedAndDrawn, AgreeFromAboveAndBelow) {
    for (const Side side : {Side::wall, Side::periodic, Side::absorbing})
        for (const bool waves : {false, true})
            for (const bool below : {false, true}) {
                const Surface surface = waves ? wavy_surface(side) : calm_surface(side);
                FloorMap map;
                const Scene scene = pool(surface, map);
                // Far off, waves that hide each other are drawn otherwise: the camera below looks down where they go
                // on.
                const glm::dvec3 ahead = side == Side::periodic ? glm::dvec3(2.2, 2, -1.5) : glm::dvec3(4, 4, -1.4);
                const Camera camera = below ? camera_at({1, 1, -0.8}, ahead) : camera_at({4, -1, 3}, {4, 3, -0.5});
                const Difference d = difference(scene, {}, camera);
                const std::string which =
                    fmt::format("side {}, waves {}, below {}", static_cast<int>(side), waves, below);
                EXPECT_LT(d.mean, 0.005) << which;
                EXPECT_LT(d.median, 0.006) << which;
                EXPECT_LT(d.ninety_fifth, 0.05) << which;
            }
}

}  // namespace
}  // namespace waterlight
