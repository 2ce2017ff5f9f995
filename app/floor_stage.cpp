#include "app/floor_stage.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "app/exact_surface.hpp"
#include "app/lit_mapper.hpp"
#include "app/readings.hpp"
#include "caustics/beam_renderer_vulkan.hpp"
#include "caustics/floor_vulkan.hpp"
#include "caustics/splat/splat_vulkan.hpp"
#include "caustics/truth.hpp"
#include "scenarios/build_floor.hpp"
#include "scenarios/resolve.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

/// The map by any method but the truth, by either back-end.
class MapperStage final : public FloorStage {
  public:
    MapperStage(FloorMethod method, const FloorSettings& settings, LitMapper lit)
        : method_(method), plan_(settings.plan), optics_(settings.optics), lit_(std::move(lit)) {}
    void compute(const Surface& surface, FloorMap& map) override { lit_.mapper->compute(surface, map); }
    MethodRecord record(const FloorMap& map) const override { return method_record(method_, lit_, map); }
    double irradiance_at(const Surface&, const FloorMap& map, glm::dvec2 at_m) const override {
        return pixel_at(plan_, map.irradiance, at_m);
    }
    LightLedger ledger(const FloorMap& map) const override {
        if (!lit_.spectral) return light_ledger(map.ledger, optics_);
        LightLedger sum;
        for (const BandMap& band : lit_.spectral->maps()) sum += light_ledger(band.map.ledger, band.band.optics);
        return sum;
    }
    std::span<const BandMap> bands() const override {
        return lit_.spectral ? std::span<const BandMap>(lit_.spectral->maps()) : std::span<const BandMap>();
    }

  private:
    FloorMethod method_;
    FloorPlan plan_;
    WaterOptics optics_;
    LitMapper lit_;
};

/// The converged map: of the formula itself where there is one, else of the smooth surface through the cells.
class TruthStage final : public FloorStage {
  public:
    TruthStage(TruthSettings settings, const SurfaceFormula* formula)
        : settings_(std::move(settings)), formula_(formula) {}

    void compute(const Surface& surface, FloorMap& map) override {
        const TruthMap truth = truth_map(settings_, exact(surface));
        map.irradiance = Field<float>(truth.irradiance.nx(), truth.irradiance.ny());
        std::copy_n(truth.irradiance.data(), truth.irradiance.size(), map.irradiance.data());
        map.ledger = truth.ledger;
        error_ = truth.error_estimate;
    }
    MethodRecord record(const FloorMap&) const override {
        return {.method = FloorMethod::truth, .error_estimate = error_};
    }
    LightLedger ledger(const FloorMap& map) const override { return light_ledger(map.ledger, settings_.floor.optics); }

    double irradiance_at(const Surface& surface, const FloorMap& map, glm::dvec2 at_m) const override {
        const FloorPlan& plan = settings_.floor.plan;
        if (std::isnan(pixel_at(plan, map.irradiance, at_m))) return std::numeric_limits<double>::quiet_NaN();
        return truth_at(settings_.floor, exact(surface), at_m, std::min(plan.pitch_m.x, plan.pitch_m.y));
    }

  private:
    TruthSurface exact(const Surface& surface) const { return exact_surface(surface, formula_); }

    TruthSettings settings_;
    const SurfaceFormula* formula_;
    double error_ = 0;
};

/// Whether there is something to compute on a Vulkan device.
bool has_vulkan_part(const Scenario& scenario) {
    return scenario.floor || scenario.beams || has_vulkan_model(scenario);
}

bool is_truth(const Scenario& scenario) { return scenario.floor && scenario.floor->method == FloorMethod::truth; }

/// Makes the mappers of parallel light of one colour.
FloorMaker back_end_maker(const Scenario& scenario, const BuiltModel& model, const BackendDecision& decision) {
    const std::shared_ptr<const Field<float>> bed = receiver_bed(scenario, model);
    const FloorMethod method = scenario.floor->method;
    if (decision.backend == Backend::vulkan && method == FloorMethod::two_pass && !bed)
        return [context = decision.context](const FloorSettings& s) { return make_floor_vulkan(s, context); };
    if (decision.backend == Backend::vulkan && method == FloorMethod::splat)
        return [&scenario, bed, context = decision.context](const FloorSettings& s) {
            return make_splat_floor_vulkan(splat_settings(scenario, s, bed), context);
        };
    return floor_maker(scenario, bed);
}

}  // namespace

std::string processor_name() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name") && line.find(": ") != std::string::npos)
            return line.substr(line.find(": ") + 2);
    return "unknown processor";
}

BackendDecision choose_backend(const DeviceWish& wish, const Scenario& scenario) {
    const BackendDecision on_cpu{Backend::cpu, processor_name(), "", nullptr};
    const auto because = [&](std::string reason) {
        BackendDecision decision = on_cpu;
        decision.reason = std::move(reason);
        return decision;
    };
    if (wish.backend == Backend::cpu && !wish.device.empty())
        throw InputError("--device: found it beside --backend cpu; allowed: --backend vulkan or auto");
    const bool wants_vulkan = wish.backend == Backend::vulkan || !wish.device.empty() || wish.validation;
    if (scenario.floor && !has_vulkan_method(scenario.floor->method)) {
        const std::string_view method = name_of(scenario.floor->method);
        // A device and its validation may be those of the pictures.
        if (wish.backend == Backend::vulkan || (wants_vulkan && !scenario.output.image))
            throw InputError(
                fmt::format("--backend: found vulkan beside method = \"{}\"; allowed: auto or cpu", method));
        return because(is_truth(scenario) ? "the truth is computed in double precision on the CPU"
                                          : fmt::format("method {} is computed on the CPU", method));
    }
    if (wish.backend == Backend::cpu) return because("stated on the command line");
    if (!wants_vulkan && !has_vulkan_part(scenario))
        return because("auto: no part of this scenario has a Vulkan back-end");
    if (!wants_vulkan && !gpu::has_real_gpu(gpu::survey()))
        return because("auto: no Vulkan device is a GPU, and a CPU computes faster by itself than through Vulkan");
    auto context =
        std::make_shared<gpu::Context>(gpu::ContextSettings{.device = wish.device, .validation = wish.validation});
    const std::string reason =
        wants_vulkan ? "stated on the command line" : "auto: " + context->selection().explanation;
    return {Backend::vulkan, context->device().name, reason, context};
}

std::unique_ptr<FloorStage> make_floor_stage(const Scenario& scenario, const BuiltModel& model,
                                             const BackendDecision& decision) {
    const FloorSettings settings = floor_settings(scenario);
    if (is_truth(scenario)) {
        TruthSettings truth;
        truth.floor = settings;
        truth.tolerance = scenario.floor->tolerance;
        truth.most_subsamples = scenario.floor->most_subsamples;
        truth.subsamples = std::min(truth.subsamples, truth.most_subsamples);
        return std::make_unique<TruthStage>(truth, model.prescribed ? model.prescribed->formula() : nullptr);
    }
    return std::make_unique<MapperStage>(
        scenario.floor->method, settings,
        make_lit_mapper(scenario, settings, back_end_maker(scenario, model, decision)));
}

std::unique_ptr<BeamRenderer> make_beam_renderer(const BackendDecision& decision) {
    return decision.backend == Backend::vulkan ? make_beam_renderer_vulkan(decision.context) : make_beam_renderer_cpu();
}

}  // namespace waterlight
