// Joints between tiles, on floor and walls, from any side: through flat and tilted water where Snell's law has them,
// and mirrored by the surface where a mirror has them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "tests/support/picture_places.hpp"
#include "tests/support/render_scenes.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

constexpr double water_m = 2, tile_m = 0.5;

/// A place in the middle between two corners of tiles, on a joint along `along`, with others a tile off `across`.
struct Joint {
    glm::dvec3 place, along, across;
};

std::vector<Joint> floor_joints() {
    std::vector<Joint> all;
    for (int k = -8; k < 24; ++k)
        for (int l = -8; l < 24; ++l) {
            all.push_back({{k * tile_m, (l + 0.5) * tile_m, -water_m}, {0, 1, 0}, {1, 0, 0}});
            all.push_back({{(l + 0.5) * tile_m, k * tile_m, -water_m}, {1, 0, 0}, {0, 1, 0}});
        }
    return all;
}

/// Of the wall x = `x` between the floor and the water.
std::vector<Joint> wall_joints(double x) {
    std::vector<Joint> all;
    for (int k = 1; k < 12; ++k)
        for (int l = 1; l < 4; ++l) {
            all.push_back({{x, k * tile_m, -(l - 0.5) * tile_m}, {0, 0, 1}, {0, 1, 0}});
            all.push_back({{x, (k + 0.5) * tile_m, -l * tile_m}, {0, 1, 0}, {0, 0, 1}});
        }
    return all;
}

class PictureJoints : public GpuTest {
  protected:
    using Seen = std::function<glm::dvec2(glm::dvec3)>;  // the pixel that shows a place

    Radiance draw(const Surface& surface, const Camera& camera, double n) {
        Scene scene;
        scene.surface = &surface;
        scene.depth_m = water_m;
        scene.sun = {.elevation_deg = 40, .azimuth_deg = 180, .irradiance_w_m2 = 900};
        scene.optics.refractive_index = n;
        Look look = plain_look(0.8);
        look.floor.pattern = look.walls.pattern = Finish::Pattern::tiles;
        look.floor.tile_m = look.walls.tile_m = tile_m;
        look.sky.irradiance_w_m2 = 0.0;
        SceneRenderer renderer(context);
        renderer.draw(scene, look, camera);
        return renderer.read_radiance();
    }

    /// The largest distance in pixels between joints as found and as predicted, of those that are in the picture with
    /// tiles of 30 pixels or more.
    static double worst(const Radiance& seen, const std::vector<Joint>& joints, const Seen& pixel) {
        double most = 0;
        int found = 0;
        for (const Joint& joint : joints) {
            const glm::dvec2 at = pixel(joint.place), run = pixel(joint.place + 1e-4 * joint.along) - at;
            const glm::dvec2 beside = pixel(joint.place + tile_m * joint.across) - at;
            const int axis = std::abs(run.x) > std::abs(run.y) ? 1 : 0, other = 1 - axis;
            if (!(std::abs(beside[axis]) > 30) || !is_inside(at, seen.size)) continue;
            const double line = std::round(at[other]);
            const double predicted = at[axis] + (line - at[other]) * run[axis] / run[other];
            most = std::max(most, std::abs(dark_centre(seen, axis, static_cast<int>(line), predicted) - predicted));
            ++found;
        }
        EXPECT_GE(found, 10);
        return most;
    }

  private:
    static constexpr int reach = 10;

    static bool is_inside(glm::dvec2 at, glm::ivec2 size) {
        return at.x > reach + 2 && at.y > reach + 2 && at.x < size.x - reach - 3 && at.y < size.y - reach - 3;
    }

    /// The centre of the joint within `reach` pixels of a place on a row (axis 0) or column (axis 1), each pixel
    /// counted by the part of it that the joint covers. The tiles on both sides differ.
    static double dark_centre(const Radiance& seen, int axis, int line, double place) {
        const int middle = static_cast<int>(std::lround(place));
        std::array<double, 2 * reach + 1> v{};
        for (int k = -reach; k <= reach; ++k)
            v[k + reach] = axis == 0 ? radiance_at(seen, middle + k, line).y : radiance_at(seen, line, middle + k).y;
        const auto darkest = std::ranges::min_element(v);
        double sum = 0, moment = 0;
        for (auto it = v.begin(); it != v.end(); ++it) {
            const double tile = it < darkest ? v.front() : v.back();
            const double part = std::clamp((tile - *it) / (tile - *darkest), 0.0, 1.0);
            if (part < 0.04) continue;  // light that changes evenly over the tiles
            sum += part;
            moment += part * static_cast<double>(it - v.begin() - reach);
        }
        EXPECT_LT(*darkest, 0.9 * std::min(v.front(), v.back())) << "no joint near " << place << " on " << line;
        return middle + moment / sum;
    }
};

const std::array<Camera, 4>& cameras_above() {
    static const std::array<Camera, 4> all{
        camera_at({1, 1, 2.5}, {4, 3.2, 0}, {640, 480}), camera_at({4.1, 2.9, 4}, {4.1, 2.9, 0}, {640, 480}),
        camera_at({6, -1, 1.5}, {4, 3.5, 0}, {640, 480}), camera_at({-2, 0.3, 1.2}, {2, 2, 0}, {640, 480})};
    return all;
}

TEST_F(PictureJoints, OfAFloorUnderFlatWaterFromAnySide) {
    for (const double n : {1.2, 4.0 / 3.0, 1.5})
        for (const Camera& camera : cameras_above()) {
            const Radiance seen = draw(calm_surface(Side::periodic), camera, n);
            const double pixels = worst(seen, floor_joints(), [&](glm::dvec3 place) {
                return test::pixel_of(camera, test::leaves_water(camera.position_m, place, n));
            });
            RecordProperty(fmt::format("pixels_n{:.2f}_from_{:.1f}", n, camera.position_m.x),
                           fmt::format("{}", pixels));
            EXPECT_LT(pixels, 0.25) << "n = " << n << ", eye at x = " << camera.position_m.x;
        }
}

TEST_F(PictureJoints, OfAFloorUnderTiltedWaterFromAnySide) {
    constexpr double n = 4.0 / 3.0;
    for (const glm::dvec2 slope : {glm::dvec2{0.1, 0.06}, {-0.08, 0.12}, {0.02, -0.1}})
        for (const Camera& camera : {cameras_above()[0], cameras_above()[1]}) {
            const Surface surface =
                test::sample(make_grid(32, 24, 8, 6), {Side::periodic, Side::periodic}, test::tilted(slope), slope);
            const Radiance seen = draw(surface, camera, n);
            const double pixels = worst(seen, floor_joints(), [&](glm::dvec3 place) {
                return test::pixel_of(camera, test::leaves_water(camera.position_m, place, n, slope));
            });
            EXPECT_LT(pixels, 0.25) << slope.x << ", " << slope.y << ", eye at x = " << camera.position_m.x;
        }
}

TEST_F(PictureJoints, OfAWallUnderFlatWater) {
    for (const double n : {1.2, 4.0 / 3.0, 1.5})
        for (const glm::dvec3 eye : {glm::dvec3{5, 2, 1.5}, {3, 4.5, 2}, {6.5, 3, 3}}) {
            const Camera camera = camera_at(eye, {8, 3, -0.3}, {640, 480});
            const double pixels =
                worst(draw(calm_surface(Side::wall), camera, n), wall_joints(8),
                      [&](glm::dvec3 place) { return test::pixel_of(camera, test::leaves_water(eye, place, n)); });
            EXPECT_LT(pixels, 0.25) << "n = " << n << ", eye at x = " << eye.x;
        }
}

// Beyond Snell's window the floor is seen as far above the surface as it is below.
TEST_F(PictureJoints, OfAFloorInTheMirrorOfTheSurface) {
    constexpr double n = 4.0 / 3.0;
    for (const glm::dvec3 eye : {glm::dvec3{1, 1, -0.5}, {2, 3.1, -1.2}}) {
        Camera camera = camera_at(eye, {eye.x + 3, eye.y + 1, 0.7}, {640, 480});
        camera.fov_deg = 35;
        const double pixels = worst(draw(calm_surface(Side::periodic), camera, n), floor_joints(), [&](glm::dvec3 p) {
            const glm::dvec3 mirrored{p.x, p.y, -p.z}, d = glm::normalize(mirrored - eye);
            const bool total = std::hypot(d.x, d.y) > 1.02 / n;
            return total ? test::pixel_of(camera, mirrored) : glm::dvec2(-1e9);
        });
        EXPECT_LT(pixels, 0.25) << "eye at z = " << eye.z;
    }
}

/// Standard deviation of the middle colour, and of its difference from another picture.
struct Spread {
    double own = 0, difference = 0;
};

Spread spread(const Radiance& a, const std::vector<double>& b) {
    const auto count = static_cast<double>(b.size());
    double sum = 0, squares = 0, off = 0;
    for (std::size_t k = 0; k < b.size(); ++k) {
        const double v = a.rgb[3 * k + 1];
        sum += v / count;
        squares += v * v / count;
        off += (v - b[k]) * (v - b[k]) / count;
    }
    return {std::sqrt(squares - sum * sum), std::sqrt(off)};
}

// Under waves that widen and narrow tiles, joints are finer than pixels; each shows the mean of what it covers.
TEST_F(PictureJoints, UnderWavesAPixelIsTheMeanOfAFinerPicture) {
    constexpr int finer = 8;
    const Surface surface = wavy_surface(Side::periodic);
    const glm::ivec2 size{120, 90};
    const Radiance coarse = draw(surface, camera_at({4.1, 2.9, 3}, {4.3, 3.1, 0}, size), 4.0 / 3);
    const Radiance fine = draw(surface, camera_at({4.1, 2.9, 3}, {4.3, 3.1, 0}, finer * size), 4.0 / 3);
    std::vector<double> means(static_cast<std::size_t>(size.x * size.y));
    for (int j = 0; j < fine.size.y; ++j)
        for (int i = 0; i < fine.size.x; ++i)
            means[static_cast<std::size_t>(j / finer * size.x + i / finer)] +=
                radiance_at(fine, i, j).y / (finer * finer);
    Radiance mean = coarse;
    for (std::size_t k = 0; k < means.size(); ++k) mean.rgb[3 * k + 1] = static_cast<float>(means[k]);
    const Spread found = spread(coarse, means), right = spread(mean, means);
    RecordProperty("contrast", fmt::format("{:.3f}", found.own / right.own));
    RecordProperty("difference", fmt::format("{:.3f}", found.difference / right.own));
    EXPECT_NEAR(found.own / right.own, 1, 0.1);
    EXPECT_LT(found.difference / right.own, 0.3);
}

}  // namespace
}  // namespace waterlight
