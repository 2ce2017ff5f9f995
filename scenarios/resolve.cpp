#include "scenarios/resolve.hpp"

#include <cassert>

namespace waterlight {

namespace {

bool states_a_formula(const WavesSection& waves) { return waves.slope || waves.file || waves.gerstner; }

}  // namespace

ModelDecision resolve_model(const Scenario& scenario) {
    const ModelChoice stated = scenario.waves.model;
    if (stated != ModelChoice::automatic) return {stated, {"stated in the scenario"}};
    if (states_a_formula(scenario.waves))
        return {ModelChoice::prescribed, {"auto: the scenario gives the surface by a formula or a file"}};
    return {ModelChoice::airy,
            {"auto: caustics are focused by short waves, whose speed depends on their length",
             "airy is exact in time over a flat floor for waves of any length"}};
}

Boundary resolve_boundary(const Scenario& scenario) {
    const WavesSection& waves = scenario.waves;
    const bool repeats = resolve_model(scenario).model == ModelChoice::prescribed || waves.spectrum || waves.buoy;
    const Side open = repeats ? Side::periodic : Side::wall;
    return {waves.boundary_x.value_or(open), waves.boundary_y.value_or(open)};
}

Grid grid_of(const Scenario& scenario) {
    const DomainSection& d = scenario.domain;
    return make_grid(d.cells.x, d.cells.y, d.size_m.x, d.size_m.y);
}

FloorSettings floor_settings(const Scenario& scenario) {
    assert(scenario.floor);
    const FloorSection& floor = *scenario.floor;
    const glm::dvec2 domain = scenario.domain.size_m;
    const glm::dvec2 size = floor.size_m.value_or(domain), centre = floor.centre_m.value_or(domain * 0.5);
    FloorSettings settings;
    settings.plan.width = floor.pixels.x;
    settings.plan.height = floor.pixels.y;
    settings.plan.pitch_m = size / glm::dvec2(floor.pixels);
    settings.plan.angle_deg = floor.angle_deg;
    settings.plan.origin_m = centre - 0.5 * (size.x * settings.plan.axis_x() + size.y * settings.plan.axis_y());
    settings.window = floor.window;
    // An even number is the paper's M, the rows beside the own one.
    if (settings.window && settings.window->channels % 2 == 0) ++settings.window->channels;
    settings.depth_m = scenario.domain.depth_m;
    settings.sun = scenario.light;
    settings.optics = scenario.optics;
    return settings;
}

}  // namespace waterlight
