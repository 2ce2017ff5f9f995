// Which checks a scenario can have, before anything is run.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenarios/build.hpp"
#include "scenarios/combinations.hpp"
#include "scenarios/document.hpp"
#include "scenarios/exact.hpp"
#include "scenarios/nearest.hpp"
#include "scenarios/quantities.hpp"
#include "scenarios/resolve.hpp"

namespace waterlight {

namespace {

/// Whether it is of a probe below the surface.
bool is_in_water(const Scenario& s, const std::string& quantity) {
    return std::any_of(s.probes.begin(), s.probes.end(), [&](const Probe& probe) {
        return probe.depth_m && quantity.starts_with("probe." + probe.name + ".");
    });
}

/// The section that a quantity needs and the scenario lacks; else empty.
std::string_view lacking_section(const Scenario& s, const std::string& quantity) {
    if (quantity.starts_with("accuracy.")) return s.accuracy.estimate ? "" : "accuracy.estimate = true";
    const bool of_floor = quantity.starts_with("floor.") || is_of_light(quantity);
    if (quantity.starts_with("beams.")) return s.beams ? "" : "[caustics.beams]";
    if (quantity.starts_with("walls.")) return s.walls ? "" : "[caustics.walls]";
    if (quantity.starts_with("volume.")) return s.beams && s.beams->volume_cells ? "" : "caustics.beams.volume_cells";
    if (quantity.starts_with("camera."))
        return sees_scattered_light(s) ? "" : s.camera ? "beams that the camera sees" : "[camera]";
    if (quantity.starts_with("sea.")) return s.waves.spectrum || s.waves.buoy ? "" : "waves.spectrum or waves.buoy";
    if (is_in_water(s, quantity)) return "";
    if (quantity.ends_with(".scalar_irradiance")) return "depth_m of that probe";
    return of_floor && !s.floor ? "[caustics.floor]" : "";
}

/// One check, with its key for what is said about it.
struct CheckOf {
    const Scenario& s;
    const Check& check;
    const std::vector<std::string>& known;  ///< quantities that the scenario has
    std::string key;

    [[noreturn]] void reject_at(const char* sub, const std::string& found, const std::string& allowed) const {
        s.origin.reject(key + sub, found, allowed);
    }

    void require_known() const {
        if (std::find(known.begin(), known.end(), check.quantity) != known.end()) return;
        reject(s.origin.place(key + ".quantity"), key + ".quantity", fmt::format("\"{}\"", check.quantity),
               "a number of the report or probe.NAME.elevation (`waterlight schema` lists them)",
               nearest_word(check.quantity, known));
    }

    /// What the run cannot have is refused.
    void require_had() const {
        const std::string& q = check.quantity;
        const auto require = [&](bool has, std::string_view lacks, std::string_view allowed) {
            if (!has) reject_at(".quantity", fmt::format("\"{}\" {}", q, lacks), std::string(allowed));
        };
        const std::string_view section = lacking_section(s, q);
        require(section.empty(), fmt::format("without {}", section), fmt::format("{} in the scenario", section));
        require_model(s, is_of_shallow_water(q), key + ".quantity", {ModelChoice::shallow_water});
        const auto is_by = [&](FloorMethod method) { return s.floor && s.floor->method == method; };
        const bool moves = resolve_model(s).model != ModelChoice::prescribed;
        require(q != "floor.truth_error" || is_by(FloorMethod::truth), "without method = \"truth\"", "method truth");
        require(q != "floor.photon_error" || is_by(FloorMethod::photons), "without method = \"photons\"",
                "method photons");
        require(!q.starts_with("floor.splat_") || is_by(FloorMethod::splat), "without method = \"splat\"",
                "method splat");
        require(q != "waves.energy" || moves, "of a surface that is prescribed", "another model");
        require(q != "waves.volume_drift" || is_closed(s), "beside sides that let water pass", "closed sides");
        require(q != "waves.exact_l1" || has_exact(s, "surface.depth"), "without an exact state",
                "an exact state in waves.initial");
        require(q != "waves.energy_drift" || (moves && conserves_energy_from_s(s) < s.waves.duration_s),
                "where energy comes in or goes out until the end",
                "closed sides, no friction, no wavemaker, and drops that fall before the end");
    }

    void require_times() const {
        const QuantityKind kind = kind_of(check.quantity);
        const double end = s.waves.duration_s;
        if (check.at_s && check.window_s) reject_at(".window_s", "it beside at_s", "one of both");
        if (check.at_s && *check.at_s > end)
            reject_at(".at_s", fmt::format("{}", *check.at_s), fmt::format("at most waves.duration_s = {}", end));
        if (check.window_s) require_window(kind);
        if (check.over && (!check.window_s || kind == QuantityKind::of_series))
            reject_at(".over", "it without values to take together", "window_s beside it, of a number of each frame");
        const double every = s.output.probe_every_s.value_or(s.output.every_s);
        const double from = check.window_s ? check.window_s->x : 0, to = check.window_s ? check.window_s->y : end;
        constexpr double least_rows = 16;
        if (kind == QuantityKind::of_series && (check.at_s.value_or(to) - from) / every < least_rows)
            reject_at(".quantity", fmt::format("\"{}\" of too few rows", check.quantity),
                      "a window of 16 times output.probe_every_s at least");
    }

    void require_window(QuantityKind kind) const {
        const glm::dvec2 w = *check.window_s;
        const bool of_rows = kind == QuantityKind::of_series || is_row_quantity(check.quantity);
        const double every = of_rows ? s.output.probe_every_s.value_or(s.output.every_s) : s.output.every_s;
        if (kind == QuantityKind::of_run)
            reject_at(".window_s", fmt::format("it beside \"{}\", which tells of the run so far", check.quantity),
                      "at_s, or a number of each frame");
        if (w.x >= w.y || w.y > s.waves.duration_s)
            reject_at(".window_s", fmt::format("[{}, {}]", w.x, w.y),
                      fmt::format("[first, last] within [0, waves.duration_s = {}]", s.waves.duration_s));
        if (w.y - w.x < every)
            reject_at(".window_s", fmt::format("[{}, {}]", w.x, w.y),
                      fmt::format("at least {} s, from frame to frame", every));
    }

    void require_reference() const {
        const std::optional<FieldStatistic> of = field_statistic(check.quantity);
        if (!check.reference) {
            if (of && of->is_relative() && !check.agrees)
                reject_at(".quantity", fmt::format("\"{}\" without a reference", check.quantity),
                          "reference beside it");
            return;
        }
        if (!of) reject_at(".reference", fmt::format("it beside \"{}\"", check.quantity), "a statistic of a field");
        const std::string& reference = *check.reference;
        if (reference == "exact") {
            if (!has_exact(s, of->field))
                reject_at(".reference", fmt::format("\"exact\" of {}", of->field),
                          "surface.depth of an exact waves.initial, surface.elevation or a slope of standing waves and "
                          "sines alone (models linear and airy)");
            return;
        }
        const bool is_field = reference.ends_with(".vti") || reference.ends_with(".pvd");
        if (!is_field && !check.is_against_scenario())
            reject_at(".reference", fmt::format("\"{}\"", reference),
                      "exact, or the path of a .vti, a .pvd or a .toml");
        if (!is_written(of->field))
            reject_at(".reference", fmt::format("a file of {}", of->field),
                      "surface.elevation, surface.depth, floor.irradiance, camera.radiance or a field of volume");
        if (check.window_s) reject_at(".window_s", "it beside a file or a scenario", "at_s, or the end");
    }

    void require_expectation() const {
        if (!check.states_bound() && !check.order && !check.agrees)
            reject_at("", "no expectation", "equals with a tolerance, below, above, between, order or agrees");
        if (check.equals && check.tolerance == 0 && check.relative_tolerance == 0)
            reject_at(".equals", "it without a tolerance", "tolerance or relative_tolerance > 0");
        if (check.between && check.between->x > check.between->y)
            reject_at(".between", fmt::format("[{}, {}]", check.between->x, check.between->y), "[least, greatest]");
        if (check.order && (check.states_bound() || check.agrees || check.is_against_scenario()))
            reject_at(".order", "it beside another expectation", "order alone");
        if (check.order) require_order();
        if (check.agrees) require_agreement();
    }

    void require_order() const {
        const std::vector<std::string> keys = known_keys();
        std::string plain;
        for (std::size_t i = 0; i < check.order->key.size(); ++i) {
            if (check.order->key[i] == '[') i = std::min(check.order->key.find(']', i), check.order->key.size() - 1);
            if (check.order->key[i] != ']') plain += check.order->key[i];
        }
        if (std::find(keys.begin(), keys.end(), plain) != keys.end()) return;
        reject(s.origin.place(key + ".order.key"), key + ".order.key", fmt::format("\"{}\"", check.order->key),
               "a key of the scenario", nearest_word(plain, keys));
    }

    void require_agreement() const {
        const Agreement& agrees = *check.agrees;
        const std::optional<FieldStatistic> of = field_statistic(check.quantity);
        const bool is_norm = of && of->is_norm();
        if (check.states_bound() || check.reference)
            reject_at(".agrees", "it beside another expectation", "agrees alone");
        if (agrees.tolerance == 0 && agrees.relative_tolerance == 0)
            reject_at(".agrees", "it without a tolerance", "tolerance or relative_tolerance > 0");
        if (is_norm && agrees.relative_tolerance > 0)
            reject_at(".agrees.relative_tolerance", "it beside a norm of a field",
                      "tolerance, of relative_l2 or the like");
        if (is_norm && !is_written(of->field))
            reject_at(".agrees", fmt::format("it beside a norm of {}", of->field),
                      "surface.elevation, surface.depth, floor.irradiance, camera.radiance or a field of volume");
        if (is_norm && check.window_s) reject_at(".window_s", "it beside a norm of a difference", "at_s, or the end");
        if (!is_of_both_backends())
            reject_at(
                ".agrees", fmt::format("it beside \"{}\", which the CPU alone computes", check.quantity),
                "numbers of the floor's map by method two-pass or splat, of fields in the water, of pictures, or of "
                "the model shallow-water");
    }

    /// Whether a Vulkan device computes what the quantity tells of. Beams themselves, and what a probe in the water
    /// reads of them, are the CPU's.
    bool is_of_both_backends() const {
        const std::string& q = check.quantity;
        if (s.floor && !has_vulkan_method(s.floor->method)) return false;
        if (has_vulkan_model(s) || q.starts_with("volume.") || q.starts_with("camera.")) return true;
        return s.floor && (q.starts_with("floor.") || is_of_light(q)) && !is_in_water(s, q);
    }
};

}  // namespace

void check_checks(const Scenario& s) {
    const std::vector<std::string> known = quantity_names(s);
    for (std::size_t i = 0; i < s.checks.size(); ++i) {
        const CheckOf check{s, s.checks[i], known, fmt::format("check[{}]", i)};
        check.require_known();
        check.require_had();
        check.require_times();
        check.require_reference();
        check.require_expectation();
    }
}

}  // namespace waterlight
