#include "scenarios/build.hpp"

#include <cassert>

#include "sim/airy.hpp"
#include "sim/linear.hpp"
#include "sim/prescribed.hpp"

namespace waterlight {

namespace {

bool states_a_formula(const WavesSection& waves) { return waves.slope || waves.file || waves.gerstner; }

LinearSettings linear_settings(const Scenario& s) {
    LinearSettings settings;
    settings.grid = grid_of(s);
    settings.boundary = resolve_boundary(s);
    settings.water = s.water;
    settings.cfl = s.waves.cfl.value_or(settings.cfl);
    settings.sponge_m = s.waves.margin_m.value_or(0);
    settings.sines = s.waves.sines;
    settings.standing = s.waves.standing;
    settings.sources = s.waves.sources;
    return settings;
}

AirySettings airy_settings(const Scenario& s) {
    AirySettings settings;
    settings.grid = grid_of(s);
    settings.boundary = resolve_boundary(s);
    settings.water = s.water;
    settings.margin_m = s.waves.margin_m.value_or(0);
    settings.sines = s.waves.sines;
    settings.standing = s.waves.standing;
    settings.sources = s.waves.sources;
    if (s.waves.spectrum) settings.sea = Sea{make_spectrum(*s.waves.spectrum, s.water), s.waves.spectrum->seed};
    if (s.waves.buoy) settings.sea = Sea{read_buoy(*s.waves.buoy, s.water), s.waves.buoy->seed};
    return settings;
}

PrescribedSettings prescribed_settings(const Scenario& s) {
    PrescribedSettings settings;
    settings.grid = grid_of(s);
    settings.boundary = resolve_boundary(s);
    settings.water = s.water;
    settings.slope = s.waves.slope.value_or(glm::dvec2{0, 0});
    settings.sines = s.waves.sines;
    settings.gerstner = s.waves.gerstner;
    if (s.waves.file) settings.file = *s.waves.file;
    return settings;
}

template <class Model>
BuiltModel built(std::unique_ptr<Model> model, const Model* BuiltModel::*own) {
    BuiltModel result;
    result.*own = model.get();
    result.model = std::move(model);
    return result;
}

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

BuiltModel build_model(const Scenario& scenario) {
    switch (resolve_model(scenario).model) {
        case ModelChoice::linear: {
            BuiltModel result;
            result.model = make_linear<float>(linear_settings(scenario));
            return result;
        }
        case ModelChoice::prescribed:
            return built(make_prescribed(prescribed_settings(scenario)), &BuiltModel::prescribed);
        default:
            break;
    }
    const AirySettings settings = airy_settings(scenario);
    BuiltModel result = built(make_airy(settings), &BuiltModel::airy);
    if (settings.sea) result.sea = settings.sea->spectrum.description;
    return result;
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
    settings.depth_m = scenario.domain.depth_m;
    settings.sun = scenario.light;
    settings.optics = scenario.optics;
    return settings;
}

}  // namespace waterlight
