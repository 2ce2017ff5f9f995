#include "app/view/controls.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/orbit_camera.hpp"
#include "render/pick.hpp"

namespace waterlight {

namespace {

constexpr double degrees_by_pixel = 0.3;
constexpr double flown_by_second = 0.3;  // of the water's diagonal
constexpr double sunk = 0.4;             // of the ball's radius, its centre below the water that was clicked

glm::dvec3 within(const Grid& grid, glm::dvec3 at) {
    return {glm::clamp(at.x, grid.x0_m, grid.x0_m + grid.width_m()),
            glm::clamp(at.y, grid.y0_m, grid.y0_m + grid.height_m()), at.z};
}

}  // namespace

Controls::Controls(Session& session, ViewState& state) : session_(session), state_(state) {}

// Windows count from the upper left corner, cameras from the middle of the lower left pixel.
glm::dvec2 Controls::pixel(glm::dvec2 at) const { return {at.x - 0.5, state_.camera.size.y - at.y - 0.5}; }

void Controls::handle(const WindowEvent& event, const Snapshot& snapshot, bool over_panel, bool panel_takes_keys) {
    using Type = WindowEvent::Type;
    if (event.type == Type::key && !panel_takes_keys) key(event.key);
    if (event.type == Type::press && drag_ == Drag::none && !over_panel) press(event, snapshot);
    if (event.type == Type::release && event.button == dragged_by_) release();
    if (event.type == Type::move) move(event, snapshot);
    if (event.type == Type::scroll && !over_panel) state_.camera = zoomed(state_.camera, event.scroll);
    mouse_ = event.at;
}

void Controls::press(const WindowEvent& event, const Snapshot& snapshot) {
    dragged_by_ = event.button;
    if (event.button == MouseButton::middle) drag_ = Drag::pan;
    if (event.button == MouseButton::right) drag_ = event.shift ? Drag::pan : event.control ? Drag::look : Drag::orbit;
    if (event.button != MouseButton::left) return;
    const std::optional<glm::dvec3> water = pick_water(snapshot.surface, state_.camera, pixel(event.at));
    if (!water) return;
    if (state_.tool == Tool::drop && !event.shift) {
        session_.drop(glm::dvec2(*water), state_.drop_radius_m, state_.drop_height_m);
        return;
    }
    drag_ = Drag::sphere;
    sphere_level_m_ = water->z - sunk * state_.sphere_radius_m;
    session_.hold_sphere({{water->x, water->y, sphere_level_m_}, state_.sphere_radius_m});
}

void Controls::release() {
    finish();
    if (drag_ == Drag::sphere) session_.release_sphere();
    drag_ = Drag::none;
}

void Controls::move(const WindowEvent& event, const Snapshot& snapshot) {
    const glm::dvec2 by = event.at - mouse_, degrees = degrees_by_pixel * by;
    if (drag_ == Drag::orbit) state_.camera = orbited(state_.camera, -degrees.x, degrees.y);
    if (drag_ == Drag::look) state_.camera = turned(state_.camera, -degrees.x, -degrees.y);
    if (drag_ == Drag::pan) state_.camera = panned(state_.camera, {by.x, -by.y});
    if (drag_ != Drag::sphere) return;
    if (const auto at = pick_level(sphere_level_m_, state_.camera, pixel(event.at)))
        sphere_at_m_ = within(snapshot.surface.grid, *at);
}

void Controls::finish() {
    if (sphere_at_m_) session_.move_sphere(*sphere_at_m_);
    sphere_at_m_.reset();
}

void Controls::key(Key key) {
    if (key == Key::space) session_.status().plays ? session_.pause() : session_.play();
    if (key == Key::period) session_.step();
    if (key == Key::r) session_.reset();
    if (key == Key::p || key == Key::f2) state_.wants_screenshot = true;
    if (key == Key::escape) state_.closes = true;
}

void Controls::fly(const Window& window, const Snapshot& snapshot, double seconds) {
    const auto axis = [&](Key forth, Key back) { return double(window.is_held(forth)) - double(window.is_held(back)); };
    const glm::dvec3 by{axis(Key::d, Key::a), axis(Key::w, Key::s), axis(Key::e, Key::q)};
    if (by == glm::dvec3(0)) return;
    const Grid& grid = snapshot.surface.grid;
    const double speed = flown_by_second * glm::length(glm::dvec2(grid.width_m(), grid.height_m()));
    state_.camera = flown(state_.camera, speed * seconds * by);
}

}  // namespace waterlight
