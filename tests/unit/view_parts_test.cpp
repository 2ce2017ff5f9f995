// What a view decides by itself: how large pictures are drawn, from where the water is seen at first.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/view/picture_size.hpp"
#include "app/view/view_state.hpp"

namespace waterlight {
namespace {

constexpr glm::ivec2 window{1280, 720};

/// Draws pictures whose time goes with their pixels; returns the last one's size and its time.
std::pair<glm::ivec2, double> settle(PictureSize& size, double whole_ms) {
    double ms = 0;
    for (int n = 0; n < 40; ++n) {
        const glm::ivec2 pixels = size.of(window, 0);
        ms = whole_ms * pixels.x * pixels.y / (window.x * window.y);
        size.learn(ms);
    }
    return {size.of(window, 0), ms};
}

TEST(PictureSize, IsTheWindowsWhereThatIsQuick) {
    PictureSize size;
    EXPECT_EQ(settle(size, 20).first, window);
}

TEST(PictureSize, ShrinksUntilPicturesComeQuicklyAndGrowsAgain) {
    PictureSize size;
    for (const double whole_ms : {100.0, 400.0, 3000.0}) {
        const auto [pixels, ms] = settle(size, whole_ms);
        EXPECT_LT(pixels.x, window.x);
        EXPECT_LE(ms, 70) << whole_ms;
    }
    EXPECT_EQ(settle(size, 20).first, window);
}

TEST(PictureSize, KeepsItsSizeWhereTheTimeStaysTheSame) {
    PictureSize size;
    const glm::ivec2 pixels = settle(size, 200).first;
    for (int n = 0; n < 20; ++n) EXPECT_EQ(settle(size, 200).first, pixels);
}

TEST(PictureSize, TakesTheDivisorThatIsWished) {
    const PictureSize size;
    EXPECT_EQ(size.of(window, 3), glm::ivec2(426, 240));
    EXPECT_EQ(size.of({2, 1}, 4), glm::ivec2(1, 1));
}

Scenario pool(glm::dvec2 size_m, glm::ivec2 cells) {
    Scenario scenario;
    scenario.domain.size_m = size_m;
    scenario.domain.cells = cells;
    scenario.domain.depth_m = 2;
    return scenario;
}

TEST(InitialState, SeesAllOfTheWaterFromAbove) {
    for (const glm::dvec2 size_m : {glm::dvec2(8, 6), glm::dvec2(300, 300), glm::dvec2(0.4, 5)}) {
        const ViewState state = initial_state(pool(size_m, {128, 96}), window);
        EXPECT_EQ(state.camera.size, window);
        EXPECT_GT(state.camera.position_m.z, 0);
        const Camera::Rays rays = state.camera.rays();
        for (const double x : {0.0, size_m.x})
            for (const double y : {0.0, size_m.y}) {
                const glm::dvec3 to = glm::dvec3(x, y, 0) - state.camera.position_m;
                const glm::dvec3 on_plane = to / glm::dot(to, rays.forward) - rays.corner;
                const double i = glm::dot(on_plane, rays.right) / glm::dot(rays.right, rays.right);
                const double j = glm::dot(on_plane, rays.up) / glm::dot(rays.up, rays.up);
                EXPECT_TRUE(i > 0 && i < window.x && j > 0 && j < window.y) << x << ' ' << y;
            }
    }
}

TEST(InitialState, TakesTheScenariosCamera) {
    Scenario scenario = pool({8, 6}, {128, 96});
    scenario.camera.emplace().camera = {.position_m = {1, 1, -1}, .target_m = {4, 3, -0.5}, .fov_deg = 70};
    const Camera camera = initial_state(scenario, window).camera;
    EXPECT_EQ(camera.position_m, glm::dvec3(1, 1, -1));
    EXPECT_EQ(camera.target_m, glm::dvec3(4, 3, -0.5));
    EXPECT_EQ(camera.fov_deg, 70);
    EXPECT_EQ(camera.size, window);
}

TEST(InitialState, DropsAreWiderThanTheCellsThatCarryThem) {
    const ViewState coarse = initial_state(pool({8, 6}, {16, 12}), window);
    EXPECT_GE(coarse.drop_radius_m, 3 * 0.5);
    const ViewState fine = initial_state(pool({8, 6}, {1024, 768}), window);
    EXPECT_NEAR(fine.drop_radius_m, 0.12, 1e-12);
}

}  // namespace
}  // namespace waterlight
