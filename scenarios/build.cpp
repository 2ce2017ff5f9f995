#include "scenarios/build.hpp"

#include "scenarios/build_shallow.hpp"
#include "scenarios/resolve.hpp"
#include "sim/airy.hpp"
#include "sim/linear.hpp"
#include "sim/prescribed.hpp"
#include "sim/shallow_water_vulkan.hpp"

namespace waterlight {

namespace {

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

std::unique_ptr<ShallowWaterModel> shallow_model(const Scenario& s, const std::shared_ptr<gpu::Context>& context) {
    const ShallowWaterSettings settings = shallow_settings(s);
    return context ? make_shallow_water_vulkan(settings, context) : make_shallow_water<float>(settings);
}

template <class Model>
BuiltModel built(std::unique_ptr<Model> model, const Model* BuiltModel::*own) {
    BuiltModel result;
    result.*own = model.get();
    result.model = std::move(model);
    return result;
}

}  // namespace

bool has_vulkan_model(const Scenario& scenario) { return resolve_model(scenario).model == ModelChoice::shallow_water; }

bool has_vulkan_method(FloorMethod method) { return method == FloorMethod::two_pass || method == FloorMethod::splat; }

BuiltModel build_model(const Scenario& scenario, const std::shared_ptr<gpu::Context>& context) {
    switch (resolve_model(scenario).model) {
        case ModelChoice::linear: {
            BuiltModel result;
            result.model = make_linear<float>(linear_settings(scenario));
            return result;
        }
        case ModelChoice::shallow_water:
            return built(shallow_model(scenario, context), &BuiltModel::shallow);
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

}  // namespace waterlight
