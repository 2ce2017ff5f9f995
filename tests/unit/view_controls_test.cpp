// What the mouse and the keys of a view do to the camera and to a session that rests.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>

#include "app/view/controls.hpp"
#include "scenarios/reader.hpp"

namespace waterlight {
namespace {

namespace fs = std::filesystem;
using Type = WindowEvent::Type;

Scenario pool() {
    const fs::path file = fs::temp_directory_path() / "waterlight view controls.toml";
    std::ofstream(file) << "[domain]\nsize_m = [2.0, 1.5]\ncells = [48, 36]\ndepth_m = 0.8\n"
                           "[waves]\nmodel = \"airy\"\nboundary = { x = \"wall\", y = \"wall\" }\nduration_s = 1.0\n";
    Scenario scenario = read_scenario(file);
    fs::remove(file);
    return scenario;
}

/// Straight down on the middle of the water: a pixel of the window is a hundredth of a metre.
class ControlsTest : public ::testing::Test {
  protected:
    void SetUp() override {
        state.camera.size = {400, 300};
        state.camera.target_m = {1, 0.75, 0};
        state.camera.position_m = {1, 0.75, 1.5 / std::tan(25 * std::numbers::pi / 180)};
    }

    void send(Type type, glm::dvec2 at, MouseButton button = MouseButton::left, bool shift = false) {
        controls.handle({.type = type, .at = at, .button = button, .shift = shift}, *session.latest(), false, false);
    }
    void press(Key key) { controls.handle({.type = Type::key, .key = key}, *session.latest(), false, false); }
    /// After all that was sent.
    std::shared_ptr<const Snapshot> settled() {
        session.await(session.speed(1));
        return session.latest();
    }
    bool is_calm() {
        const std::shared_ptr<const Snapshot> snapshot = settled();
        const auto values = snapshot->surface.elevation.values();
        return std::all_of(values.begin(), values.end(), [](float v) { return v == 0; });
    }

    const Scenario scenario = pool();
    Session session{scenario, {.backend = Backend::cpu, .device = "", .validation = false}, {.plays = false}};
    ViewState state = initial_state(scenario, {400, 300});
    Controls controls{session, state};
};

TEST_F(ControlsTest, ALeftClickDropsWhereItIs) {
    send(Type::press, {250, 120});
    send(Type::release, {250, 120});
    const std::shared_ptr<const Snapshot> snapshot = settled();
    const auto values = snapshot->surface.elevation.values();
    const auto highest = std::max_element(values.begin(), values.end()) - values.begin();
    const Grid& grid = snapshot->surface.grid;
    EXPECT_NEAR(grid.x_m(static_cast<int>(highest % grid.nx)), 1.5, grid.dx_m);
    EXPECT_NEAR(grid.y_m(static_cast<int>(highest / grid.nx)), 1.05, grid.dy_m);
}

TEST_F(ControlsTest, AClickBesideTheWaterOrOnAPanelDoesNothing) {
    send(Type::press, {50, 150});
    send(Type::release, {50, 150});
    controls.handle({.type = Type::press, .at = {200, 150}}, *session.latest(), true, false);
    EXPECT_TRUE(is_calm());
}

TEST_F(ControlsTest, AShiftedDragPullsABallAndLetsItGo) {
    send(Type::press, {150, 150}, MouseButton::left, true);
    ASSERT_TRUE(settled()->sphere);
    EXPECT_NEAR(settled()->sphere->centre_m.x, 0.5, 0.02);
    send(Type::move, {200, 140});
    send(Type::move, {220, 130});
    controls.finish();
    EXPECT_NEAR(settled()->sphere->centre_m.x, 1.2, 0.02);
    EXPECT_NEAR(settled()->sphere->centre_m.y, 0.95, 0.02);
    EXPECT_FALSE(is_calm());
    send(Type::release, {220, 130});
    EXPECT_FALSE(settled()->sphere);
}

TEST_F(ControlsTest, ARightDragGoesRoundAndTouchesNoWater) {
    const Camera before = state.camera;
    send(Type::move, {200, 150});
    send(Type::press, {200, 150}, MouseButton::right);
    send(Type::move, {230, 100});
    EXPECT_NE(state.camera.position_m, before.position_m);
    EXPECT_EQ(state.camera.target_m, before.target_m);
    const Camera during = state.camera;
    send(Type::release, {230, 100}, MouseButton::right);
    send(Type::move, {300, 20});
    EXPECT_EQ(state.camera, during) << "the drag is over";
    EXPECT_TRUE(is_calm());
}

TEST_F(ControlsTest, TheWheelGoesNearerUnlessAPanelHasIt) {
    const double before = state.camera.position_m.z;
    controls.handle({.type = Type::scroll, .at = {200, 150}, .scroll = 1}, *session.latest(), true, false);
    EXPECT_EQ(state.camera.position_m.z, before);
    controls.handle({.type = Type::scroll, .at = {200, 150}, .scroll = 1}, *session.latest(), false, false);
    EXPECT_NEAR(state.camera.position_m.z, 0.9 * before, 1e-9);
}

TEST_F(ControlsTest, KeysStepResetAndPlay) {
    press(Key::period);
    EXPECT_NEAR(settled()->time_s, 1.0 / 30, 1e-9);
    press(Key::r);
    EXPECT_EQ(settled()->time_s, 0);
    press(Key::space);
    settled();
    EXPECT_TRUE(session.status().plays);
    press(Key::p);
    EXPECT_TRUE(state.wants_screenshot);
    controls.handle({.type = Type::key, .key = Key::escape}, *session.latest(), false, true);
    EXPECT_FALSE(state.closes) << "the user writes into a panel";
    press(Key::escape);
    EXPECT_TRUE(state.closes);
}

}  // namespace
}  // namespace waterlight
