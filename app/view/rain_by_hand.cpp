#include "app/view/rain_by_hand.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenarios/resolve.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

/// Some hundred drops a frame: beyond it rain only costs.
constexpr double most_drops_per_s = 5000;

/// A scenario's rain must end after it begins: what ends so soon does not fall.
constexpr double no_time_s = 1e-9;

void require_rate(const Scenario& scenario, double rate) {
    const double area = scenario.domain.size_m.x * scenario.domain.size_m.y;
    if (rate > 0 && rate * area <= most_drops_per_s) return;
    throw InputError(fmt::format("rain: found {} drops/(m2 s); allowed: above 0, at most {:.6g} on {:.6g} m2", rate,
                                 most_drops_per_s / area, area));
}

/// Drops that cells carry: a radius of two and a half of them, and slopes that do not break.
std::string new_rain(const Scenario& scenario, std::size_t n, double rate) {
    const Grid grid = grid_of(scenario);
    const double radius = std::max(0.02, 2.5 * std::max(grid.dx_m, grid.dy_m));
    return fmt::format(
        "waves.source[{}]={{type = \"rain\", drops_per_m2_s = {:.17g}, radius_m = [{:.6g}, {:.6g}], height_m = "
        "[{:.6g}, {:.6g}]}}",
        n, rate, radius, 2 * radius, -0.15 * radius, -0.05 * radius);
}

}  // namespace

std::vector<std::string> rain_overrides(const Scenario& scenario, std::optional<double> drops_per_m2_s) {
    if (drops_per_m2_s) require_rate(scenario, *drops_per_m2_s);
    std::vector<std::string> overrides;
    bool falls = false;
    const std::vector<Source>& sources = scenario.waves.sources;
    for (std::size_t n = 0; n < sources.size(); ++n) {
        if (!std::holds_alternative<Rain>(sources[n])) continue;
        const std::string key = fmt::format("waves.source[{}]", n);
        if (drops_per_m2_s && !falls) {
            falls = true;
            overrides.push_back(fmt::format("{}.drops_per_m2_s={:.17g}", key, *drops_per_m2_s));
            overrides.push_back(key + ".start_s=0.0");
            overrides.push_back(key + ".end_s=1e30");
        } else {
            overrides.push_back(key + ".start_s=0.0");
            overrides.push_back(fmt::format("{}.end_s={}", key, no_time_s));
        }
    }
    if (drops_per_m2_s && !falls) overrides.push_back(new_rain(scenario, sources.size(), *drops_per_m2_s));
    return overrides;
}

std::vector<Rain> rain_of(const Scenario& scenario) {
    std::vector<Rain> all;
    for (const Source& source : scenario.waves.sources)
        if (const auto* rain = std::get_if<Rain>(&source); rain && rain->end_s > rain->start_s + no_time_s)
            all.push_back(*rain);
    return all;
}

}  // namespace waterlight
