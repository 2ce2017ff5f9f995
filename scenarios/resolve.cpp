#include "scenarios/resolve.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace waterlight {

namespace {

bool states_a_formula(const WavesSection& waves) {
    const auto frozen = [](const Sine& sine) { return sine.frozen; };
    return waves.slope || waves.file || waves.gerstner || std::any_of(waves.sines.begin(), waves.sines.end(), frozen);
}

bool is_of_shallow_water(const Scenario& s) {
    const WavesSection& w = s.waves;
    return !w.initial.empty() || !w.inflows.empty() || w.manning || w.wet_m || s.domain.bathymetry ||
           !s.domain.ground.empty();
}

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Time after which a source adds no energy.
struct Silence {
    double operator()(const Drop& drop) const { return drop.time_s; }
    double operator()(const Rain& rain) const { return rain.end_s; }
    double operator()(const Wavemaker&) const { return infinity; }
};

}  // namespace

ModelDecision resolve_model(const Scenario& scenario) {
    const ModelChoice stated = scenario.waves.model;
    if (scenario.decided && scenario.decided->model == stated) return *scenario.decided;
    if (stated != ModelChoice::automatic) return {stated, {"stated in the scenario"}, {}};
    if (states_a_formula(scenario.waves))
        return {ModelChoice::prescribed, {"auto: the scenario gives the surface by a formula or a file"}, {}};
    if (is_of_shallow_water(scenario))
        return {ModelChoice::shallow_water, {"auto: the scenario has ground, flow or jumps"}, {}};
    return {ModelChoice::airy,
            {"auto: caustics are focused by short waves, whose speed depends on their length",
             "airy is exact in time over a flat floor for waves of any length"},
            {}};
}

SideChoices resolve_sides(const Scenario& scenario) {
    const WavesSection& w = scenario.waves;
    const bool repeats = resolve_model(scenario).model == ModelChoice::prescribed || w.spectrum || w.buoy;
    const SideChoice open = repeats ? SideChoice::periodic : SideChoice::wall;
    const SideChoice x = w.boundary_x.value_or(open), y = w.boundary_y.value_or(open);
    return {w.boundary_west.value_or(x), w.boundary_east.value_or(x), w.boundary_south.value_or(y),
            w.boundary_north.value_or(y)};
}

Boundary resolve_boundary(const Scenario& scenario) {
    const SideChoices sides = resolve_sides(scenario);
    const std::vector<Inflow>& inflows = scenario.waves.inflows;
    const auto is_wall = [&](SideChoice choice, DomainSide side) {
        if (choice != SideChoice::inflow) return choice == SideChoice::wall;
        return std::any_of(inflows.begin(), inflows.end(),
                           [side](const Inflow& i) { return i.side == side && i.kind == InflowKind::piston; });
    };
    const auto seen = [&](SideChoice low, DomainSide low_side, SideChoice high, DomainSide high_side) {
        if (is_wall(low, low_side) || is_wall(high, high_side)) return Side::wall;
        return low == SideChoice::periodic ? Side::periodic : Side::absorbing;
    };
    return {seen(sides.west, DomainSide::west, sides.east, DomainSide::east),
            seen(sides.south, DomainSide::south, sides.north, DomainSide::north)};
}

bool is_closed(const Scenario& scenario) {
    const SideChoices sides = resolve_sides(scenario);
    const auto closed = [](SideChoice side) { return side == SideChoice::periodic || side == SideChoice::wall; };
    return closed(sides.west) && closed(sides.east) && closed(sides.south) && closed(sides.north);
}

double conserves_energy_from_s(const Scenario& scenario) {
    if (!is_closed(scenario) || scenario.waves.manning.value_or(0) > 0) return infinity;
    double from = -infinity;
    for (const Source& source : scenario.waves.sources) from = std::max(from, std::visit(Silence{}, source));
    return from;
}

double still_volume_m3(const Scenario& scenario) {
    const DomainSection& d = scenario.domain;
    return resolve_model(scenario).model == ModelChoice::shallow_water ? 0 : d.size_m.x * d.size_m.y * d.depth_m;
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
    settings.footprint = floor.footprint;
    settings.samples_per_pixel = floor.samples_per_pixel;
    settings.window = floor.window;
    // An even number is the paper's M, the rows beside the own one.
    if (settings.window && settings.window->channels % 2 == 0) ++settings.window->channels;
    settings.depth_m = scenario.domain.depth_m;
    settings.sun = scenario.light;
    settings.optics = scenario.optics;
    settings.objects = scenario.object_set;
    return settings;
}

BeamSettings beam_settings(const Scenario& scenario) {
    assert(scenario.beams);
    const BeamsSection& beams = *scenario.beams;
    const glm::dvec2 domain = scenario.domain.size_m;
    BeamSettings settings;
    settings.grid = beams.grid;
    if (beams.size_m)
        settings.window = BeamWindow{beams.centre_m.value_or(domain * 0.5) - 0.5 * *beams.size_m, *beams.size_m};
    settings.depth_m = scenario.domain.depth_m;
    settings.sun = scenario.light;
    settings.optics = scenario.optics;
    settings.objects = scenario.object_set;
    return settings;
}

BeamSettings reflected_settings(const Scenario& scenario) {
    assert(scenario.beams && scenario.beams->reflected);
    const ReflectedSection& reflected = *scenario.beams->reflected;
    BeamSettings settings = beam_settings(scenario);
    settings.depth_m = reflected.height_m;
    settings.optics.absorption_per_m = reflected.absorption_per_m;
    settings.optics.scattering_per_m = reflected.scattering_per_m;
    settings.optics.phase = reflected.phase;
    return settings;
}

bool looks_from_air(const Scenario& scenario) { return scenario.camera && scenario.camera->camera.position_m.z > 0; }

bool sees_scattered_light(const Scenario& scenario) {
    return scenario.camera && scenario.beams && (!looks_from_air(scenario) || scenario.beams->reflected);
}

bool traces_pictures(const Scenario& scenario) {
    return scenario.output.image && (!scenario.objects.empty() || scenario.lamp);
}

BeamImageSettings beam_image_settings(const Scenario& scenario) {
    assert(scenario.camera);
    constexpr double dim = 6.9;  // ln 1000
    const double longest_m = 2 * std::max(scenario.domain.size_m.x, scenario.domain.size_m.y);
    const bool air = looks_from_air(scenario);
    BeamImageSettings settings;
    settings.camera = air ? mirrored(scenario.camera->camera) : scenario.camera->camera;
    settings.optics = air ? reflected_settings(scenario).optics : scenario.optics;
    const double extinction = settings.optics.extinction_per_m();
    settings.objects = scenario.object_set;
    settings.samples = scenario.camera->samples;
    settings.reduction = scenario.camera->reduction;
    settings.range_m =
        scenario.camera->range_m.value_or(extinction > 0 ? std::min(longest_m, dim / extinction) : longest_m);
    return settings;
}

}  // namespace waterlight
