// What is under water is seen where Snell says. The predictors are written here, in double.
#include <fmt/format.h>

#include <functional>

#include "tests/support/render_scenes.hpp"

namespace waterlight {
namespace {

constexpr double depth_m = 2;

/// The water climbs by `slope` along x through z = 0 at x = 4.
Surface tilted_surface(double slope) {
    Surface surface = calm_surface(Side::periodic);
    surface.tilt = {slope, 0};
    for (int j = 0; j < surface.grid.ny; ++j)
        for (int i = 0; i < surface.grid.nx; ++i) {
            surface.elevation(i, j) = static_cast<float>(slope * (surface.grid.x_m(i) - 4));
            surface.slope_x(i, j) = static_cast<float>(slope);
        }
    return surface;
}

/// A camera in the plane y = const, and what each height in its middle column sees on the floor.
struct SideView {
    Camera camera;
    double slope = 0;
    double n = 4.0 / 3.0;

    glm::dvec3 direction(double row) const { return glm::normalize(camera.rays().at(0.5 * (camera.size.x - 1), row)); }

    /// x on the floor, through the plane z = slope (x - 4), by Snell's law for the two angles to its normal.
    double floor_x(double row) const {
        const glm::dvec3 d = direction(row), eye = camera.position_m;
        const double t = (slope * (eye.x - 4) - eye.z) / (d.z - slope * d.x);
        const double x = eye.x + t * d.x, z = eye.z + t * d.z;
        const double normal = std::atan2(-slope, 1.0);  // of the plane, from the vertical, towards +x
        const double below = std::atan2(d.x, -d.z);     // of the ray, from straight down, towards +x
        const double incidence = below + normal;
        const double refracted = std::asin(std::sin(incidence) / n) - normal;
        return x + (z + depth_m) * std::tan(refracted);
    }

    double row_of(double x) const {
        double low = 0, high = camera.size.y - 1;
        for (int step = 0; step < 60; ++step) {
            const double middle = 0.5 * (low + high);
            (floor_x(middle) < x ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }
};

class PictureRefraction : public GpuTest {
  protected:
    /// The middle column of a picture of tiles that do not differ, seen by the sun's light alone.
    std::vector<double> column(const Surface& surface, const Camera& camera) {
        Scene scene;
        scene.surface = &surface;
        scene.depth_m = depth_m;
        scene.sun = {.elevation_deg = 50, .azimuth_deg = 90, .irradiance_w_m2 = 900};  // its mirror image is elsewhere
        Look look = plain_look(0.8);
        look.floor.pattern = Finish::Pattern::tiles;
        look.floor.tile_m = tile_m;
        look.sky.irradiance_w_m2 = 0.0;
        SceneRenderer renderer(context);
        renderer.draw(scene, look, camera);
        const Radiance seen = renderer.read_radiance();
        std::vector<double> values;
        for (int j = 0; j < camera.size.y; ++j) values.push_back(radiance_at(seen, camera.size.x / 2, j).y);
        return values;
    }

    /// The largest distance (pixels) between joints as seen and as predicted.
    double worst_joint(const SideView& view) {
        const std::vector<double> seen = column(tilted_surface(view.slope), view.camera);
        const double first = view.floor_x(12), last = view.floor_x(view.camera.size.y - 13.0);
        double worst = 0;
        int joints = 0;
        for (double x = tile_m * std::ceil(first / tile_m); x < last; x += tile_m, ++joints) {
            const double predicted = view.row_of(x);
            if (view.row_of(x + tile_m) - predicted < 24) break;  // finer joints are not told apart
            worst = std::max(worst, std::abs(dark_centre(seen, predicted) - predicted));
        }
        EXPECT_GE(joints, 4);
        return worst;
    }

    /// The centre of what is darker than its surroundings within 6 pixels of a row.
    static double dark_centre(const std::vector<double>& seen, double row) {
        const int around = static_cast<int>(std::lround(row));
        const auto at = [&](int j) { return seen[static_cast<std::size_t>(j)]; };
        // Tiles differ in brightness, on either side of the joint.
        const double below = at(around - 6), above = at(around + 6);
        double sum = 0, moment = 0;
        for (int j = around - 6; j <= around + 6; ++j) {
            const double dark = std::max(0.0, std::min(below, above) - at(j));
            sum += dark;
            moment += dark * j;
        }
        EXPECT_GT(sum, 0) << "no joint near row " << row;
        return moment / sum;
    }

    static constexpr double tile_m = 0.5;
};

TEST_F(PictureRefraction, TilesUnderFlatWaterAreWhereSnellSays) {
    for (const double distance : {1.0, 2.0, 4.0}) {
        const SideView view{camera_at({4 - distance, 3.2, 2.5}, {4, 3.2, 0}, {9, 720})};
        const double worst = worst_joint(view);
        RecordProperty(fmt::format("worst_pixels_at_{:.0f}_m", distance), fmt::format("{:.3f}", worst));
        EXPECT_LT(worst, 0.25) << "from " << distance << " m";
    }
}

// The same floor without refraction is elsewhere by far: the prediction is not trivially met.
TEST_F(PictureRefraction, TilesAreNotWhereStraightRaysWouldSeeThem) {
    SideView view{camera_at({1, 3.2, 2.5}, {4, 3.2, 0}, {9, 720})};
    const double bent = view.row_of(4.5);
    view.n = 1;
    EXPECT_GT(std::abs(view.row_of(4.5) - bent), 20);
}

TEST_F(PictureRefraction, TilesUnderTiltedWaterAreWhereSnellSays) {
    for (const double slope : {-0.2, -0.05, 0.1, 0.2}) {
        const SideView view{camera_at({2, 3.2, 2.5}, {4, 3.2, 0}, {9, 720}), slope};
        EXPECT_LT(worst_joint(view), 0.25) << "slope " << slope;
    }
}

// With the index of air the surface is not there, whatever its waves: every pixel below the horizon is the floor in the
// sun.
TEST_F(PictureRefraction, WavesOfIndexOneAreInvisible) {
    const Surface surface = wavy_surface(Side::periodic);
    Scene scene;
    scene.surface = &surface;
    scene.depth_m = depth_m;
    scene.sun = {.elevation_deg = 50, .azimuth_deg = 90, .irradiance_w_m2 = 900};
    scene.optics.refractive_index = 1;
    Look look = plain_look(0.5);
    look.sky.irradiance_w_m2 = 0.0;
    SceneRenderer renderer(context);
    renderer.draw(scene, look, camera_at({4, 3, 4}, {6, 4, -1}, {160, 120}));
    const double expected = 0.5 * 900 * std::sin(50 * std::numbers::pi / 180) / std::numbers::pi;
    for (const float value : renderer.read_radiance().rgb) ASSERT_NEAR(value / expected, 1, 1e-3);
}

}  // namespace
}  // namespace waterlight
