// Which settings go together.
#include "scenarios/combinations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "scenarios/choose.hpp"
#include "scenarios/reader.hpp"
#include "scenarios/resolve.hpp"

namespace waterlight {

namespace {

constexpr double most_margins = 4;  // beyond which a margin costs more than it absorbs

bool repeats(const Boundary& b) { return b.x == Side::periodic && b.y == Side::periodic; }
bool absorbs(const Boundary& b) { return b.x == Side::absorbing || b.y == Side::absorbing; }

void check_models(const Scenario& s) {
    using enum ModelChoice;
    const WavesSection& w = s.waves;
    require_model(s, w.cfl.has_value(), "waves.cfl", {linear, shallow_water});
    require_model(s, w.slope.has_value(), "waves.slope", {prescribed});
    require_model(s, w.file.has_value(), "waves.file", {prescribed});
    require_model(s, w.gerstner.has_value(), "waves.gerstner", {prescribed});
    require_model(s, w.spectrum.has_value(), "waves.spectrum", {airy});
    require_model(s, w.buoy.has_value(), "waves.buoy", {airy});
    require_model(s, w.margin_m.has_value(), "waves.margin_m", {linear, airy});
    require_model(s, !w.sines.empty(), "waves.sine", {linear, airy, shallow_water, prescribed});
    require_model(s, !w.standing.empty(), "waves.standing", {linear, airy, shallow_water});
    require_model(s, !w.sources.empty(), "waves.source", {linear, airy, shallow_water});
    for (std::size_t i = 0; i < w.sines.size(); ++i)
        require_model(s, w.sines[i].frozen, fmt::format("waves.sine[{}].frozen", i), {prescribed});
}

void check_initial_state(const Scenario& s) {
    const WavesSection& w = s.waves;
    const Boundary boundary = resolve_boundary(s);
    if (w.spectrum && w.buoy) s.origin.reject("waves.buoy", "it beside waves.spectrum", "one of both");
    if ((w.spectrum || w.buoy) && !repeats(boundary))
        s.origin.reject("waves.boundary",
                        std::string("a side that does not repeat beside waves.") + (w.buoy ? "buoy" : "spectrum"),
                        "periodic sides");
    const double longest_m = std::max(s.domain.size_m.x, s.domain.size_m.y);
    if (w.margin_m && *w.margin_m > most_margins * longest_m)
        s.origin.reject("waves.margin_m", fmt::format("{}", *w.margin_m),
                        fmt::format("at most {} times the longer side, {} m", most_margins, most_margins * longest_m));
    if (w.margin_m && !absorbs(boundary))
        s.origin.reject("waves.margin_m", "it without an absorbing side", "waves.boundary with an absorbing side");
    const bool has_formula = !w.sines.empty() || w.slope || w.gerstner;
    if (w.file && has_formula)
        s.origin.reject("waves.file", "it beside slope, sine or gerstner", "either a file or formulas");
    if (w.gerstner && w.gerstner->wavelength_m.x > w.gerstner->wavelength_m.y)
        s.origin.reject("waves.gerstner.wavelength_m", "the longest first", "[shortest, longest]");
    const auto odd = [](int half_waves) { return half_waves % 2 != 0; };
    for (std::size_t i = 0; i < w.standing.size(); ++i) {
        const StandingWave& wave = w.standing[i];
        const std::string key = fmt::format("waves.standing[{}].half_waves_", i);
        if (boundary.x == Side::periodic && odd(wave.half_waves_x))
            s.origin.reject(key + "x", fmt::format("{}", wave.half_waves_x), "an even number between periodic sides");
        if (boundary.y == Side::periodic && odd(wave.half_waves_y))
            s.origin.reject(key + "y", fmt::format("{}", wave.half_waves_y), "an even number between periodic sides");
    }
}

struct SourceCheck {
    const Scenario& s;
    std::string key;

    void operator()(const Drop& drop) const {
        require_inside(s, key + ".at_m", drop.at_m);
        require_within_domain(drop.radius_m);
    }
    void operator()(const Rain& rain) const {
        if (rain.radius_m.x > rain.radius_m.y)
            s.origin.reject(key + ".radius_m", "the greatest first", "[least, greatest]");
        if (rain.height_m.x > rain.height_m.y)
            s.origin.reject(key + ".height_m", "the greatest first", "[least, greatest]");
        if (rain.end_s <= rain.start_s)
            s.origin.reject(key + ".end_s", fmt::format("{}", rain.end_s), fmt::format("> start_s = {}", rain.start_s));
        constexpr double most = 1e7;
        const double seconds = std::max(0.0, std::min(rain.end_s, s.waves.duration_s) - rain.start_s);
        const double drops = rain.drops_per_m2_s * s.domain.size_m.x * s.domain.size_m.y * seconds;
        if (drops > most)
            s.origin.reject(key + ".drops_per_m2_s", fmt::format("{:.3g} drops over the run", drops), "at most 1e7");
        require_within_domain(rain.radius_m.y);
    }
    void operator()(const Wavemaker& maker) const {
        require_inside(s, key + ".from_m", maker.from_m);
        require_inside(s, key + ".to_m", maker.to_m);
        if (maker.from_m == maker.to_m) s.origin.reject(key + ".to_m", "the place of from_m", "another place");
    }

  private:
    /// Each side that a drop reaches doubles its images: one far wider than the domain has no end of them.
    void require_within_domain(double radius_m) const {
        const double most = std::max(s.domain.size_m.x, s.domain.size_m.y);
        if (radius_m > most)
            s.origin.reject(key + ".radius_m", fmt::format("{}", radius_m),
                            fmt::format("at most the domain's longer side, {} m", most));
    }
};

void check_output(const Scenario& s) {
    constexpr double most_frames = 1e6, most_rows = 1e7;
    const double frames = s.waves.duration_s / s.output.every_s;
    if (frames > most_frames)
        s.origin.reject("output.every_s", fmt::format("{}, which makes {:.3g} frames", s.output.every_s, frames),
                        fmt::format("at most {:.0f} frames", most_frames));
    if (!s.output.probe_every_s) return;
    const double every = *s.output.probe_every_s, rows = s.waves.duration_s / every;
    if (every > s.output.every_s)
        s.origin.reject("output.probe_every_s", fmt::format("{}", every),
                        fmt::format("at most output.every_s = {}", s.output.every_s));
    if (rows > most_rows)
        s.origin.reject("output.probe_every_s", fmt::format("{}, which makes {:.3g} rows", every, rows),
                        fmt::format("at most {:.0f} rows", most_rows));
}

/// Refuses keys of the map that its method does not use.
void require_method(const Scenario& s, const std::string& name, const std::vector<FloorMethod>& methods) {
    const std::string key = "caustics.floor." + name;
    const FloorMethod method = s.floor->method;
    if (!s.origin.places.contains(key) || std::find(methods.begin(), methods.end(), method) != methods.end()) return;
    std::string names;
    for (const FloorMethod m : methods) names += (names.empty() ? "" : " or ") + std::string(name_of(m));
    s.origin.reject(key, fmt::format("it beside method = \"{}\"", name_of(method)), "method " + names);
}

// [caustics.floor.splat] and .photons may stand beside any method: a sweep varies it.
void check_floor(const Scenario& s) {
    if (!s.floor) return;
    using enum FloorMethod;
    const FloorSection& floor = *s.floor;
    if (floor.window) require_method(s, "window", {two_pass});
    require_method(s, "footprint", {two_pass});
    require_method(s, "samples_per_pixel", {two_pass, quads});
    require_method(s, "tolerance", {truth});
    require_method(s, "most_subsamples", {truth});
    if (floor.photons.tolerance > 0 && floor.photons.passes < 2)
        s.origin.reject("caustics.floor.photons.passes",
                        fmt::format("{} beside tolerance = {}", floor.photons.passes, floor.photons.tolerance),
                        "2 or more, between which an error is estimated");
    if (floor.window && floor.window->samples % 2 == 0)
        s.origin.reject("caustics.floor.window.samples", fmt::format("{}", floor.window->samples),
                        "an odd integer >= 1");
}

bool is_level(const GroundShape& shape) {
    const auto* plane = std::get_if<PlaneGround>(&shape.ground);
    return plane && plane->slope == glm::dvec2{0, 0};
}

/// Cells are chosen by the waves alone, which tell nothing of what else is resampled on them or made of them.
void check_cells(const Scenario& s) {
    if (s.domain.cells.x > 0) return;
    const std::vector<GroundShape>& ground = s.domain.ground;
    const bool even = !s.domain.bathymetry && std::all_of(ground.begin(), ground.end(), is_level);
    const std::string_view reason = s.waves.file ? "the surface of waves.file is resampled on them"
                                    : !even      ? "they have to tell the ground"
                                    : s.walls    ? "[caustics.walls] are lit as finely as they are"
                                                 : std::string_view();
    if (!reason.empty())
        s.origin.reject("domain.cells", "none",
                        fmt::format("cells stated, for what is chosen looks at the waves alone "
                                    "and {}",
                                    reason));
}

/// A solution on half as many cells must still be one.
void check_accuracy(const Scenario& s) {
    constexpr int least = 8;
    const glm::ivec2 n = s.domain.cells;
    if (s.accuracy.estimate && std::max(n.x, n.y) < least)
        s.origin.reject("domain.cells", fmt::format("[{}, {}] beside accuracy.estimate", n.x, n.y),
                        fmt::format("at least {} along an axis", least));
}

void check_probes(const Scenario& s) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < s.probes.size(); ++i) {
        const std::string& name = s.probes[i].name;
        const std::string key = fmt::format("probe[{}].", i);
        if (!is_plain_name(name)) s.origin.reject(key + "name", fmt::format("\"{}\"", name), plain_names);
        if (!names.insert(name).second)
            s.origin.reject(key + "name", fmt::format("\"{}\" twice", name), "one probe a name");
        require_inside(s, key + "at_m", s.probes[i].at_m);
    }
}

}  // namespace

void require_model(const Scenario& s, bool stated, std::string_view key, const std::vector<ModelChoice>& models) {
    const ModelChoice model = resolve_model(s).model;
    if (!stated || std::find(models.begin(), models.end(), model) != models.end()) return;
    std::string names;
    for (const ModelChoice m : models) names += (names.empty() ? "" : " or ") + std::string(name_of(m));
    s.origin.reject(key, fmt::format("it beside waves.model = \"{}\"", name_of(model)), "model " + names);
}

bool is_plain_name(std::string_view name) {
    const auto plain = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-'; };
    return !name.empty() && std::all_of(name.begin(), name.end(), plain);
}

bool has_ground(const Scenario& s) { return s.domain.bathymetry || !s.domain.ground.empty(); }

void require_inside(const Scenario& s, const std::string& key, glm::dvec2 at) {
    const glm::dvec2 size = s.domain.size_m;
    if (at.x >= 0 && at.x <= size.x && at.y >= 0 && at.y <= size.y) return;
    s.origin.reject(key, fmt::format("[{}, {}]", at.x, at.y),
                    fmt::format("a place in the domain [0, {}] x [0, {}] m", size.x, size.y));
}

void check_combinations(const Scenario& s) {
    check_models(s);
    check_sides(s);
    check_shallow(s);
    check_initial_state(s);
    for (std::size_t i = 0; i < s.waves.sources.size(); ++i)
        std::visit(SourceCheck{s, fmt::format("waves.source[{}]", i)}, s.waves.sources[i]);
    check_cells(s);
    check_output(s);
    check_floor(s);
    check_beams(s);
    check_light(s);
    check_objects(s);
    check_picture(s);
    check_accuracy(s);
    check_probes(s);
    check_checks(s);
}

}  // namespace waterlight
