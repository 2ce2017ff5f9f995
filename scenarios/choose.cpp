#include "scenarios/choose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "caustics/demand.hpp"
#include "scenarios/light_cost.hpp"
#include "scenarios/memory.hpp"
#include "scenarios/number.hpp"
#include "scenarios/reader.hpp"
#include "scenarios/resolve.hpp"

namespace waterlight {

namespace {

using std::numbers::pi;
constexpr double samples_a_wave = 8;  // cells and pixels of the shortest wave that the light shows

/// The key at which an error of the reader points.
std::string key_in(std::string_view message) {
    const std::size_t end = message.find(": found ");
    if (end == std::string_view::npos) return std::string(message);
    const std::size_t begin = message.rfind(": ", end - 1);
    return std::string(message.substr(begin + 2, end - begin - 2));
}

/// The key that the model cannot carry; empty where there is none.
std::string refusal(const Scenario& scenario, ModelChoice model) {
    Scenario tried = scenario;
    tried.waves.model = model;
    try {
        check_combinations(tried);
        return {};
    } catch (const InputError& error) {
        return key_in(error.what());
    }
}

/// Largest value of what has this root mean square in a scene of so many waves.
double largest_of(double rms, const SceneSpectrum& scene) {
    constexpr double steepest = 3;  // of what is random
    return std::min(steepest, std::sqrt(2.0 * static_cast<double>(scene.waves.size()))) * rms;
}

LightDemand light_demand(const Scenario& s, const SceneSpectrum& scene) {
    LightDemand light;
    const double n = s.optics.refractive_index, depth = s.domain.depth_m;
    light.focus_m = std::numeric_limits<double>::infinity();
    if ((!s.floor && !s.beams) || s.light.elevation_deg <= 0) return light;
    const double moved = focusing(s.light, n);
    double curvature = 0;
    for (const SceneWave& wave : scene.waves) {
        const double k = wave.train.wave_number, a = wave.train.amplitude_m;
        const double contrast = caustic_contrast(k, a, depth, moved);
        curvature = std::hypot(curvature, k * k * std::sqrt(wave.variance_m2));
        if (contrast > light.contrast) {
            light.contrast = contrast;
            light.strongest_m = 2 * pi / k;
            light.focus_m = focus_depth(k, a, moved);
        }
        const bool shorter = light.shortest_m == 0 || 2 * pi / k < light.shortest_m;
        if (contrast > s.accuracy.tolerance && shorter) light.shortest_m = 2 * pi / k;
    }
    Sun sun = s.light;
    if (s.floor) sun.azimuth_deg -= s.floor->angle_deg;
    light.reach_m = landing_reach(largest_of(scene.rms_slope(), scene), depth, scene.amplitude_m(), sun, n);
    light.spread = depth * moved * largest_of(curvature, scene);
    return light;
}

bool is_past_focus(const Scenario& s, const LightDemand& light) { return s.domain.depth_m > light.focus_m; }

/// Error of the adaptive footprint times the samples that the strongest wave is given, as measured on a sine before and
/// past its focus (docs/performance.md).
double adaptive_error(const Scenario& s, const LightDemand& light) {
    return (is_past_focus(s, light) ? 0.35 : 0.085) * std::min(light.contrast, 1.0);
}

/// Errors of the footprints; the pixel-wide one's is that at any resolution. No map is further from the truth than one
/// without the waves' contrast.
void judge_footprints(const Scenario& s, glm::dvec2 sample_m, LightDemand& light) {
    if (!(light.contrast > 0)) return;
    const double strength = std::min(light.contrast, 1.0);
    const double samples = light.strongest_m / std::max(sample_m.x, sample_m.y);
    light.pixel_error = (is_past_focus(s, light) ? 0.3 : 0.08) * strength;
    const double adaptive = std::min(adaptive_error(s, light) / samples, light.contrast);
    light.footprint_error = s.floor->footprint == Footprint::pixel ? light.pixel_error : adaptive;
}

/// Counts along the sides of a rectangle: as stated, or enough for what the light shows.
glm::ivec2 cells_or_pixels(const LightDemand& light, glm::dvec2 size_m, glm::ivec2 stated, double pitch_m) {
    if (stated.x > 0) return stated;
    const double few = std::max(size_m.x, size_m.y) / 64;
    const double pitch = std::min(light.shortest_m > 0 ? light.shortest_m / samples_a_wave : few, pitch_m);
    return glm::ivec2(glm::clamp(glm::ceil(size_m / pitch), glm::dvec2(16), glm::dvec2(8192)));
}

glm::dvec2 vertex_pitch_m(const Scenario& s) {
    return glm::dvec2(std::sqrt(s.domain.size_m.x * s.domain.size_m.y / vertices_of(s)));
}

/// Relative standard error of a map: of n photons of a pass in a pixel, which are stratified, n^-3/4 (docs/objects.md).
double photon_noise(const Scenario& s, glm::ivec2 pixels) {
    const glm::dvec2 domain = s.domain.size_m, map = s.floor->size_m.value_or(domain);
    const double passes = s.floor->photons.passes;
    const double on_map = photons_of(s) / passes * std::min(1.0, map.x * map.y / (domain.x * domain.y));
    const double blur = s.floor->photons.blur_pixels,
                 shared = std::max(1.0, 4 * pi * blur * blur);  // by so many pixels
    const double on_pixel = shared * on_map / (pixels.x * static_cast<double>(pixels.y));
    const double noise = std::pow(on_pixel, on_pixel > 1 ? -0.75 : -0.5) / std::sqrt(passes);
    return s.floor->photons.tolerance > 0 ? std::max(noise, s.floor->photons.tolerance) : noise;
}

void size_floor(const Scenario& s, LightDemand& light) {
    const FloorSection& floor = *s.floor;
    light.method = floor.method;
    const double per_pixel = floor.samples_per_pixel;
    const glm::dvec2 size = floor.size_m.value_or(s.domain.size_m);
    const bool two_pass = floor.method == FloorMethod::two_pass, wide = two_pass && floor.footprint == Footprint::pixel;
    const bool resolves = two_pass || floor.method == FloorMethod::quads || floor.method == FloorMethod::splat;
    const double wanted = adaptive_error(s, light) / s.accuracy.tolerance;  // samples of the strongest wave
    const double pitch = !resolves || wide || !(wanted > 0) ? std::numeric_limits<double>::infinity()
                                                            : per_pixel * light.strongest_m / wanted;
    light.pixels = cells_or_pixels(light, size, floor.pixels, pitch);
    const glm::dvec2 sample_m = size / glm::dvec2(light.pixels) / per_pixel;
    const glm::dvec2 reach = light.reach_m / sample_m;
    const glm::dvec2 spread = wide ? glm::dvec2(0) : glm::min(glm::dvec2(light.spread), reach);
    light.window = 2 * glm::ivec2(glm::ceil(reach + spread)) + 1;
    judge_footprints(s, floor.method == FloorMethod::splat ? glm::max(sample_m, vertex_pitch_m(s)) : sample_m, light);
    if (floor.method == FloorMethod::truth) light.footprint_error = floor.tolerance;
    if (floor.method == FloorMethod::photons) light.footprint_error = photon_noise(s, light.pixels);
}

/// Pixels, beams and what they cost, once the surface's cells are known.
void size_light(const Scenario& s, glm::ivec2 cells, LightDemand& light) {
    if (s.floor) size_floor(s, light);
    if (s.beams)
        light.beams = cells_or_pixels(light, s.beams->size_m.value_or(s.domain.size_m), s.beams->grid,
                                      std::numeric_limits<double>::infinity());
    light.seconds = light_seconds(s, light, cells);
}

/// Of the run as it is chosen.
double bytes_of(const Scenario& scenario, const Decision& d) {
    Scenario chosen = scenario;
    chosen.waves.model = d.choice().model;
    chosen.domain.cells = d.choice().cells;
    if (chosen.floor) chosen.floor->pixels = d.light.pixels;
    if (chosen.beams) chosen.beams->grid = d.light.beams;
    return estimate_memory(chosen).total();
}

bool better(const Forecast& a, const Forecast& b, double tolerance) {
    const bool a_meets = a.error() <= tolerance, b_meets = b.error() <= tolerance;
    if (a_meets != b_meets) return a_meets;
    return a_meets ? a.seconds < b.seconds : a.error() < b.error();
}

/// The largest breaking_ratio() of the waves; 0 of bores, which do break.
double breaking_of(const SceneSpectrum& scene, const Water& water) {
    double most = 0;
    for (const SceneWave& wave : scene.waves) most = std::max(most, breaking_ratio(wave.train, water));
    return scene.bores ? 0 : most;
}

void require_not_strict(const Scenario& s, const std::string& warning) {
    if (s.accuracy.strict && !warning.empty())
        s.origin.reject("accuracy.tolerance", fmt::format("{}; {}", s.accuracy.tolerance, warning),
                        "another tolerance or scene, or accuracy.strict = false");
}

Beyond what_is_beyond(const Decision& d) {
    if (d.breaking > 1) return Beyond::breaking;
    if (d.meets || d.stated || d.choice().model_error <= d.tolerance) return Beyond::nothing;
    return d.scene.jump_m > 0 ? Beyond::bores_in_deep_water : Beyond::dispersive_and_nonlinear;
}

std::string against(const Forecast& rung, double tolerance, const Forecast& chosen) {
    const std::string name(name_of(rung.model));
    if (!rung.allowed) return fmt::format("{} cannot carry {}", name, rung.refusal);
    if (rung.error() > tolerance)
        return fmt::format("{} would be wrong by {} of a wavelength: {}", name, percent(rung.error()), rung.binding());
    return fmt::format("{} would do as well ({}) at {} times the cost", name, percent(rung.error()),
                       rounded(rung.seconds / chosen.seconds, 2));
}

}  // namespace

std::vector<std::string> Decision::reasons() const {
    const Forecast& c = choice();
    std::vector<std::string> lines;
    if (c.model == ModelChoice::prescribed) {
        lines.emplace_back("the scenario gives the surface by a formula or a file");
        return lines;
    }
    lines.push_back(fmt::format("{}: {} is wrong by {} of a wavelength, of {} allowed; {} binds",
                                stated ? "stated in the scenario" : "auto", name_of(c.model), percent(c.error()),
                                percent(tolerance), c.binding()));
    for (const Forecast& rung : rungs)
        if (rung.model != c.model) lines.push_back(against(rung, tolerance, c));
    return lines;
}

std::string Decision::warning() const {
    const Forecast& c = choice();
    const std::string least = fmt::format("{} is the least wrong: by {} of a wavelength, of {} allowed",
                                          name_of(c.model), percent(c.error()), percent(tolerance));
    switch (beyond) {
        case Beyond::breaking:
            return fmt::format("no model holds: waves {} times as steep as those that break; {}", rounded(breaking, 2),
                               least);
        case Beyond::dispersive_and_nonlinear:
            return "no model meets the tolerance: these waves are dispersive and nonlinear at once; " + least;
        case Beyond::bores_in_deep_water:
            return "no model meets the tolerance: a jump in water too deep for a bore breaks up into waves; " + least;
        case Beyond::nothing:
            break;
    }
    if (meets) return {};
    return fmt::format("the tolerance is not met: {} is wrong by {} of a wavelength, of {} allowed ({})",
                       name_of(c.model), percent(c.error()), percent(tolerance), c.binding());
}

std::string Decision::light_warning() const {
    if (light.pixels.x == 0 || light.footprint_error <= tolerance) return {};
    if (light.method == FloorMethod::photons)
        return fmt::format(
            "the floor map is noisy: by some {}, of {} allowed; more caustics.floor.photons.passes would leave less",
            percent(light.footprint_error), percent(tolerance));
    return fmt::format(
        "the floor map is not resolved: its footprint leaves some {}, of {} allowed; more pixels or "
        "samples_per_pixel with footprint \"adaptive\" would leave less",
        percent(light.footprint_error), percent(tolerance));
}

std::string_view name_of(ModelChoice model) {
    constexpr std::string_view names[] = {"auto", "linear", "airy", "shallow-water", "prescribed"};
    return names[static_cast<int>(model)];
}

Decision choose(const Scenario& scenario) {
    Decision d;
    d.tolerance = scenario.accuracy.tolerance;
    d.stated = scenario.waves.model != ModelChoice::automatic;
    d.scene = scene_spectrum(scenario);
    d.breaking = breaking_of(d.scene, scenario.water);
    d.light = light_demand(scenario, d.scene);
    const GridNeeds needs{d.tolerance, d.light.shortest_m > 0 ? d.light.shortest_m / samples_a_wave
                                                              : std::numeric_limits<double>::infinity()};
    const ModelChoice tentative = resolve_model(scenario).model;
    std::vector<ModelChoice> ladder{ModelChoice::linear, ModelChoice::airy, ModelChoice::shallow_water};
    if (tentative == ModelChoice::prescribed) ladder = {ModelChoice::prescribed};
    for (const ModelChoice model : ladder) {
        d.rungs.push_back(forecast(scenario, d.scene, model, needs));
        d.rungs.back().refusal = refusal(scenario, model);
        d.rungs.back().allowed = d.rungs.back().refusal.empty();
    }
    const auto fits = [&](const Forecast& rung) { return rung.allowed && (!d.stated || rung.model == tentative); };
    std::size_t best = d.rungs.size();
    for (std::size_t i = 0; i < d.rungs.size(); ++i)
        if (fits(d.rungs[i]) && (best == d.rungs.size() || better(d.rungs[i], d.rungs[best], d.tolerance))) best = i;
    if (best == d.rungs.size()) check_combinations(scenario);
    d.chosen = std::min(best, d.rungs.size() - 1);
    d.meets = d.choice().error() <= d.tolerance && d.breaking <= 1;
    d.beyond = what_is_beyond(d);
    size_light(scenario, d.choice().cells, d.light);
    d.rungs[d.chosen].bytes = bytes_of(scenario, d);
    return d;
}

bool is_open(const Scenario& s) {
    return s.waves.model == ModelChoice::automatic || s.domain.cells.x == 0 || (s.floor && s.floor->pixels.x == 0) ||
           (s.beams && s.beams->grid.x == 0);
}

void settle(Scenario& s, const Decision& d) {
    const std::string warning = d.warning();
    require_not_strict(s, warning);
    s.decided = ModelDecision{d.choice().model, d.reasons(), warning};
    s.waves.model = d.choice().model;
    s.domain.cells = d.choice().cells;
    if (s.floor) s.floor->pixels = d.light.pixels;
    if (s.beams) s.beams->grid = d.light.beams;
}

void warn_of_breaking(Scenario& s) {
    const ModelDecision stated = resolve_model(s);
    if (stated.model != ModelChoice::linear && stated.model != ModelChoice::airy) return;
    const double breaking = breaking_of(scene_spectrum(s), s.water);
    if (breaking <= 1) return;
    const std::string warning = fmt::format(
        "waves {:.2g} times as steep as those that break are out of the range of {}", breaking, name_of(stated.model));
    require_not_strict(s, warning);
    s.decided = ModelDecision{stated.model, stated.reasons, warning};
}

}  // namespace waterlight
