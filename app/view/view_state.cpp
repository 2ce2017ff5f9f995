#include "app/view/view_state.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/orbit_camera.hpp"
#include "scenarios/resolve_picture.hpp"

namespace waterlight {

namespace {

// Whether a place lies in the middle nine tenths of the picture.
bool is_seen(const Camera& camera, glm::dvec3 place) {
    const Camera::Rays rays = camera.rays();
    const glm::dvec3 to = place - camera.position_m;
    if (glm::dot(to, rays.forward) <= 0) return false;
    const glm::dvec3 from_corner = to / glm::dot(to, rays.forward) - rays.corner;
    const glm::dvec2 pixel(glm::dot(from_corner, rays.right) / glm::dot(rays.right, rays.right),
                           glm::dot(from_corner, rays.up) / glm::dot(rays.up, rays.up));
    const glm::dvec2 off = glm::abs(2.0 * (pixel + 0.5) / glm::dvec2(camera.size) - 1.0);
    return off.x < 0.9 && off.y < 0.9;
}

// From the south, and a little from the west, as near as the whole surface is seen.
Camera overview(const DomainSection& domain, glm::ivec2 pixels) {
    Camera camera;
    camera.size = pixels;
    camera.target_m = {0.5 * domain.size_m, -0.3 * domain.depth_m};
    camera.position_m = camera.target_m - glm::dvec3(0, 0.25 * glm::length(domain.size_m), 0);
    camera = orbited(camera, -20, 42);
    const auto sees_all = [&] {
        for (const double x : {0.0, domain.size_m.x})
            for (const double y : {0.0, domain.size_m.y})
                if (!is_seen(camera, {x, y, 0})) return false;
        return true;
    };
    while (!sees_all()) camera = zoomed(camera, -0.2);
    return camera;
}

}  // namespace

ViewState initial_state(const Scenario& scenario, glm::ivec2 window_size) {
    ViewState state;
    state.camera = scenario.camera ? scenario.camera->camera : overview(scenario.domain, window_size);
    state.camera.size = window_size;
    const bool has_overlay = scenario.picture.look.overlay != Overlay::none;
    state.look = has_overlay ? look_of(scenario) : scenario.picture.look;
    const glm::dvec2 size = scenario.domain.size_m, cell = size / glm::dvec2(scenario.domain.cells);
    const double side = std::min(size.x, size.y);
    state.drop_radius_m = std::max(0.02 * side, 3 * std::max(cell.x, cell.y));
    state.drop_height_m = 0.35 * state.drop_radius_m;
    state.sphere_radius_m = std::max(0.05 * side, 4 * std::max(cell.x, cell.y));
    return state;
}

}  // namespace waterlight
