// Cameras that the mouse and the keys move.
#include "render/orbit_camera.hpp"

#include <gtest/gtest.h>

namespace waterlight {
namespace {

const Camera above{.position_m = {-4, -3, 5}, .target_m = {4, 3, -1}, .size = {320, 200}};
const Camera below{.position_m = {1, 2, -1.5}, .target_m = {4, 3, 0.5}, .size = {320, 200}};
const Camera straight_down{.position_m = {4, 3, 9}, .target_m = {4, 3, 0}, .size = {320, 200}};
const Camera straight_up{.position_m = {4, 3, -2}, .target_m = {4, 3, 0}, .size = {320, 200}};

double distance(const Camera& camera) { return glm::distance(camera.position_m, camera.target_m); }

double elevation_deg(const Camera& camera) {
    const glm::dvec3 view = glm::normalize(camera.target_m - camera.position_m);
    return std::asin(view.z) * 180 / std::numbers::pi;
}

/// Pixel of a point, y upwards.
glm::dvec2 seen_at(const Camera& camera, glm::dvec3 point) {
    const Camera::Rays rays = camera.rays();
    const glm::dvec3 to = point - camera.position_m;
    const glm::dvec3 on_plane = to / glm::dot(to, rays.forward) - rays.corner;
    return {glm::dot(on_plane, rays.right) / glm::dot(rays.right, rays.right),
            glm::dot(on_plane, rays.up) / glm::dot(rays.up, rays.up)};
}

void expect_same(glm::dvec3 a, glm::dvec3 b) { EXPECT_LT(glm::distance(a, b), 1e-9); }

TEST(OrbitCamera, OrbitKeepsTheDistanceAndTheTarget) {
    for (const Camera& start : {above, below, straight_down, straight_up})
        for (const glm::dvec2 by : {glm::dvec2(30, 0), glm::dvec2(-200, 15), glm::dvec2(5, -70), glm::dvec2(0, 400)}) {
            const Camera turned = orbited(start, by.x, by.y);
            EXPECT_NEAR(distance(turned), distance(start), 1e-9);
            EXPECT_EQ(turned.target_m, start.target_m);
        }
}

TEST(OrbitCamera, AFullCircleLeadsBack) {
    Camera camera = above;
    for (int n = 0; n < 36; ++n) camera = orbited(camera, 10, 0);
    expect_same(camera.position_m, above.position_m);
}

TEST(OrbitCamera, OrbitTurnsCounterClockwiseAndUpwards) {
    const Camera camera{.position_m = {3, 0, 0}, .target_m = {0, 0, 0}};
    expect_same(orbited(camera, 90, 0).position_m, {0, 3, 0});
    expect_same(orbited(camera, 0, 30).position_m, {3 * std::sqrt(0.75), 0, 1.5});
}

TEST(OrbitCamera, NeverGoesOverThePole) {
    for (const double step : {7.0, -7.0}) {
        Camera camera = above;
        const glm::dvec3 right = camera.rays().right;
        for (int n = 0; n < 40; ++n) {
            camera = orbited(camera, 0, step);
            EXPECT_GT(glm::dot(camera.rays().right, right), 0) << "the picture flipped after " << n;
            EXPECT_GT(camera.rays().up.z, 0);
        }
        EXPECT_NEAR(std::abs(elevation_deg(camera)), 90 - pole_gap_deg, 1e-9);
    }
}

TEST(OrbitCamera, LeavesAViewAlongTheVerticalWithoutAJump) {
    for (const Camera& start : {straight_down, straight_up}) {
        const Camera moved = orbited(start, 0, start.position_m.z > 0 ? -1 : 1);
        EXPECT_GT(glm::dot(glm::normalize(moved.rays().right), glm::normalize(start.rays().right)), 0.999);
        EXPECT_GT(glm::dot(glm::normalize(moved.rays().up), glm::normalize(start.rays().up)), 0.999);
    }
}

TEST(OrbitCamera, PanMovesWhatIsAtTheTargetWithTheMouse) {
    for (const Camera& start : {above, below, straight_down}) {
        const Camera moved = panned(start, {37, -21});
        const glm::dvec2 shift = seen_at(moved, start.target_m) - seen_at(start, start.target_m);
        EXPECT_NEAR(shift.x, 37, 1e-9);
        EXPECT_NEAR(shift.y, -21, 1e-9);
        EXPECT_NEAR(distance(moved), distance(start), 1e-9);
    }
}

TEST(OrbitCamera, ZoomGoesATenthOfTheWayForEachNotchAndBack) {
    EXPECT_NEAR(distance(zoomed(above, 1)), 0.9 * distance(above), 1e-12);
    expect_same(zoomed(zoomed(above, 3), -3).position_m, above.position_m);
    EXPECT_EQ(zoomed(above, 5).target_m, above.target_m);
    EXPECT_NEAR(distance(zoomed(above, 1000, 0.2)), 0.2, 1e-12);
    EXPECT_NEAR(distance(zoomed(above, -1000)), 1e6, 1e-3);
}

TEST(OrbitCamera, FlightIsAlongTheView) {
    const glm::dvec3 view = glm::normalize(below.target_m - below.position_m);
    const Camera ahead = flown(below, {0, 2, 0});
    expect_same(ahead.position_m, below.position_m + 2.0 * view);
    expect_same(ahead.target_m - ahead.position_m, below.target_m - below.position_m);
    const Camera aside = flown(below, {1.5, 0, 0});
    EXPECT_NEAR(glm::dot(aside.position_m - below.position_m, view), 0, 1e-12);
    EXPECT_NEAR(aside.position_m.z, below.position_m.z, 1e-12);
    EXPECT_NEAR(glm::distance(aside.position_m, below.position_m), 1.5, 1e-12);
    expect_same(flown(below, {0, 0, 1}).position_m, below.position_m + glm::dvec3(0, 0, 1));
}

TEST(OrbitCamera, LooksRoundFromWhereItIs) {
    const Camera camera{.position_m = {1, 1, 1}, .target_m = {3, 1, 1}};
    expect_same(turned(camera, 90, 0).target_m, {1, 3, 1});
    expect_same(turned(camera, 0, 30).target_m, {1 + 2 * std::sqrt(0.75), 1, 2});
    const Camera up = turned(below, 0, 500);
    EXPECT_EQ(up.position_m, below.position_m);
    EXPECT_NEAR(elevation_deg(up), 90 - pole_gap_deg, 1e-9);
    EXPECT_GT(up.rays().up.z, 0);
}

}  // namespace
}  // namespace waterlight
