#include "app/view/view_state.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "render/orbit_camera.hpp"

namespace waterlight {

namespace {

// From the south, and a little from the west.
Camera overview(const DomainSection& domain) {
    constexpr double distance_by_radius = 1.9;  // of the circle round the water: fills most of a picture of 50 degrees
    Camera camera;
    camera.target_m = {0.5 * domain.size_m, -0.3 * domain.depth_m};
    const double distance = distance_by_radius * 0.5 * glm::length(domain.size_m);
    camera.position_m = camera.target_m - glm::dvec3(0, distance, 0);
    return orbited(camera, -20, 42);
}

}  // namespace

ViewState initial_state(const Scenario& scenario, glm::ivec2 window_size) {
    ViewState state;
    state.camera = scenario.camera ? scenario.camera->camera : overview(scenario.domain);
    state.camera.size = window_size;
    const glm::dvec2 size = scenario.domain.size_m, cell = size / glm::dvec2(scenario.domain.cells);
    const double side = std::min(size.x, size.y);
    state.drop_radius_m = std::max(0.02 * side, 3 * std::max(cell.x, cell.y));
    state.drop_height_m = 0.35 * state.drop_radius_m;
    state.sphere_radius_m = std::max(0.05 * side, 4 * std::max(cell.x, cell.y));
    return state;
}

}  // namespace waterlight
