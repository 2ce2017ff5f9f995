#include "app/explain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenarios/costs.hpp"
#include "scenarios/light_cost.hpp"
#include "scenarios/number.hpp"
#include "scenarios/reader.hpp"
#include "scenarios/resolve.hpp"

namespace waterlight {

namespace {

constexpr double pi = std::numbers::pi;

std::string length(double metres) {
    if (metres < 0.01) return rounded(1000 * metres, 2) + " mm";
    return metres < 1 ? rounded(100 * metres, 3) + " cm" : rounded(metres, 3) + " m";
}

std::string duration(double seconds) {
    if (seconds == 0) return "nothing";
    if (seconds < 0.1) return rounded(1000 * seconds, 2) + " ms";
    return seconds < 600 ? rounded(seconds, 2) + " s" : rounded(seconds / 3600, 2) + " h";
}

std::string range(double low, double high) {
    return high < 1.02 * low ? rounded(high, 2) : fmt::format("{} to {}", rounded(low, 2), rounded(high, 2));
}

/// Waves that carry all but a hundredth of the variance either way, and what they are like.
std::string waves_line(const Scenario& s, const SceneSpectrum& scene) {
    if (scene.waves.empty())
        return scene.bores ? "flow and fronts, no waves of a length of their own"
                           : "none: still water, or a surface that is given";
    std::vector<SceneWave> waves = scene.waves;
    std::sort(waves.begin(), waves.end(),
              [](const auto& a, const auto& b) { return a.train.wave_number < b.train.wave_number; });
    const double all = scene.variance_m2();
    double passed = 0, n_low = 1e300, n_high = 0, ka = 0;
    double k_low = waves.back().train.wave_number, k_high = waves.front().train.wave_number;
    for (const SceneWave& wave : waves) {
        passed += wave.variance_m2;
        const double k = wave.train.wave_number;
        if (passed < 0.01 * all || passed - wave.variance_m2 > 0.99 * all) continue;
        k_low = std::min(k_low, k);
        k_high = std::max(k_high, k);
        n_low = std::min(n_low, wave.train.wavelengths);
        n_high = std::max(n_high, wave.train.wavelengths);
        ka = std::max(ka, k * wave.train.amplitude_m);
    }
    const double h = s.domain.depth_m;
    const std::string lengths = k_high > 1.02 * k_low
                                    ? fmt::format("{} to {}", length(2 * pi / k_high), length(2 * pi / k_low))
                                    : length(2 * pi / k_high);
    return fmt::format("{} long (kh {}), travel {} wavelengths; a/h {}, ka {}", lengths, range(k_low * h, k_high * h),
                       range(n_low, n_high), rounded(scene.amplitude_m() / h, 2), rounded(ka, 2));
}

std::string grid_line(const Scenario& s, const Decision& d) {
    const Forecast& c = d.choice();
    return fmt::format("{} x {} cells of {} ({}), wrong by {} of a wavelength", c.cells.x, c.cells.y,
                       length(std::min(s.domain.size_m.x / c.cells.x, s.domain.size_m.y / c.cells.y)),
                       s.domain.cells.x > 0 ? "stated" : "chosen", percent(c.grid_error));
}

std::string step_line(const Decision& d) {
    const Forecast& c = d.choice();
    if (c.step_s == 0)
        return fmt::format("that of the frames, of which there are {:.0f}: {} needs no other", c.steps,
                           name_of(c.model));
    return fmt::format("{}, the longest that is stable: {:.0f} steps", duration(c.step_s), c.steps);
}

std::string light_line(const Scenario& s, const LightDemand& light) {
    if (light.contrast == 0) return "no wave that would focus it is known beforehand";
    const std::string shortest = light.shortest_m > 0 ? fmt::format("waves down to {} show", length(light.shortest_m))
                                                      : std::string("no wave shows above the tolerance");
    return fmt::format("{}; waves of {} focus first, {} down; the floor lies at {}", shortest,
                       length(light.strongest_m), length(light.focus_m), length(s.domain.depth_m));
}

/// Of the methods that are neither two-pass nor the truth.
std::string method_line(const Scenario& s, const LightDemand& light, const char* chosen) {
    const FloorSection& floor = *s.floor;
    const std::string map = fmt::format("{} x {} pixels ({})", light.pixels.x, light.pixels.y, chosen);
    const std::string leaves = percent(light.footprint_error);
    if (floor.method == FloorMethod::quads)
        return fmt::format("{}, {} quad{} a pixel; leaves some {}", map,
                           floor.samples_per_pixel * floor.samples_per_pixel, floor.samples_per_pixel == 1 ? "" : "s",
                           leaves);
    if (floor.method == FloorMethod::splat)
        return fmt::format("{}, splats of {:.0f} vertices landed in {} steps; leaves some {}", map, vertices_of(s),
                           floor.splat.iterations, leaves);
    return fmt::format("{}, {:.0f} photons in {} pass{} at most; their noise is some {}", map, photons_of(s),
                       floor.photons.passes, floor.photons.passes == 1 ? "" : "es", leaves);
}

/// What the method follows light through, and what it does not.
std::string follows_line(const Scenario& s) {
    const FloorSection& floor = *s.floor;
    switch (floor.method) {
        case FloorMethod::two_pass:
            return "the sun through the water; objects, glass too, stop it and cast shadows";
        case FloorMethod::truth:
            return "the sun through the water; knows no objects";
        case FloorMethod::quads:
            return "the sun through the water, no gaps or overlaps at folds; objects, glass too, stop it; CPU alone";
        case FloorMethod::splat:
            return fmt::format(
                "sun or lamp, the first water, glass or mirror that it meets and up to {} interfaces from "
                "there; objects cast shadows",
                floor.splat.bounces);
        case FloorMethod::photons:
            break;
    }
    return fmt::format("sun or lamp through all water, glass and mirrors, up to {} interfaces; CPU alone",
                       floor.photons.bounces);
}

std::string objects_line(const Scenario& s) {
    std::vector<std::string> all;
    for (const ObjectSection& section : s.objects)
        all.push_back(fmt::format("{} ({} {})", section.object.name,
                                  material_names[static_cast<std::size_t>(section.object.material.type)],
                                  shape_names[section.object.shape.index()]));
    return fmt::format("{}", fmt::join(all, ", "));
}

std::string floor_line(const Scenario& s, const LightDemand& light) {
    const char* chosen = s.floor->pixels.x > 0 ? "stated" : "chosen";
    if (s.floor->method == FloorMethod::truth)
        return fmt::format("{} x {} pixels ({}), truth to {}", light.pixels.x, light.pixels.y, chosen,
                           percent(light.footprint_error));
    if (s.floor->on.receiver == Receiver::ground)
        return fmt::format("{} x {} pixels ({}) on the ground; rays a pixel apart leave some {}", light.pixels.x,
                           light.pixels.y, chosen, percent(light.footprint_error));
    if (s.floor->method != FloorMethod::two_pass) return method_line(s, light, chosen);
    const bool wide = s.floor->footprint == Footprint::pixel;
    const std::string other =
        !wide && light.pixel_error <= s.accuracy.tolerance
            ? fmt::format("; \"pixel\" would leave {} at half the cost", percent(light.pixel_error))
            : std::string();
    return fmt::format("{} x {} pixels ({}), window {} x {}; footprint \"{}\" leaves some {}{}", light.pixels.x,
                       light.pixels.y, chosen, light.window.x, light.window.y, wide ? "pixel" : "adaptive",
                       percent(light.footprint_error), other);
}

std::string cost_line(const Scenario& s, const Decision& d) {
    const double frames = frames_of_run(s);
    const glm::dvec2 cells(d.choice().cells), pixels(d.light.pixels);
    const double files =
        s.output.formats.empty() ? 0 : frames * costs::file_cell_frame * (cells.x * cells.y + pixels.x * pixels.y);
    const std::string pictures =
        s.output.image ? fmt::format(", {} for pictures", duration(scene_seconds(s))) : std::string();
    return fmt::format("some {} for the waves, {} for the light{}, {} for {:.0f} frames of files; {:.0f} MB of memory",
                       duration(d.choice().seconds), duration(d.light.seconds), pictures, duration(files), frames,
                       d.choice().bytes / 1e6);
}

std::string picture_line(const Scenario& s) {
    const glm::ivec2 size = s.camera->camera.size;
    if (traces_pictures(s))
        return fmt::format("{} x {} pixels of {} samples, traced on the CPU, for there are objects or a lamp", size.x,
                           size.y, s.picture.look.samples * s.picture.look.samples);
    return fmt::format("{} x {} pixels of {} sample{} at edges, by Vulkan; reckoned for a device that is the CPU",
                       size.x, size.y, s.picture.look.samples, s.picture.look.samples == 1 ? "" : "s");
}

}  // namespace

std::string explanation(const Scenario& s, const Decision& d) {
    std::string text;
    const auto line = [&text](std::string_view head, std::string_view body) {
        text += fmt::format("{:<10} {}\n", head, body);
    };
    line("scene", fmt::format("{:g} x {:g} m, {:g} m deep, {:g} s{}", s.domain.size_m.x, s.domain.size_m.y,
                              s.domain.depth_m, s.waves.duration_s, s.title.empty() ? "" : ": " + s.title));
    line("waves", waves_line(s, d.scene));
    const std::vector<std::string> reasons = d.reasons();
    line("model", reasons.front());
    for (std::size_t i = 1; i < reasons.size(); ++i) line("left out", reasons[i]);
    line("grid", grid_line(s, d));
    line("time step", step_line(d));
    if (s.floor || s.beams) line("light", light_line(s, d.light));
    if (!s.objects.empty()) line("objects", objects_line(s));
    if (s.floor) line("floor map", floor_line(s, d.light));
    const bool is_plain = s.floor && s.floor->method == FloorMethod::two_pass && s.objects.empty();
    if (s.floor && !is_plain) line("follows", follows_line(s));
    if (s.beams)
        line("beams", fmt::format("{} x {} cells ({})", d.light.beams.x, d.light.beams.y,
                                  s.beams->grid.x > 0 ? "stated" : "chosen"));
    if (s.output.image) line("picture", picture_line(s));
    line("cost", cost_line(s, d));
    const std::string warning = d.warning(), light_warning = d.light_warning();
    if (!warning.empty()) line("WARNING", warning);
    if (!light_warning.empty()) line("WARNING", light_warning);
    if (warning.empty() && light_warning.empty())
        line("verdict", fmt::format("within the tolerance, {} of a wavelength{}", percent(d.tolerance),
                                    s.floor ? " and of the light" : ""));
    return text;
}

std::string explain_scenario(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
    const Scenario scenario = read_open_scenario(file, overrides);
    return explanation(scenario, choose(scenario));
}

}  // namespace waterlight
