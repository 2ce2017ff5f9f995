#include "app/sweep/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "export/ticks.hpp"

namespace waterlight {

namespace {

constexpr int width = 960, height = 640;
constexpr glm::dvec2 low{110, 570}, high{930, 60};  // corners of the axes, pixels
constexpr int letters = 17;

bool is_drawn(const CostAndError& c) { return std::isfinite(c.time_s) && c.time_s > 0 && c.error > 0; }

/// Holds all values with some room around them, half a decade at least.
ValueRange range_of(const std::vector<double>& values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const double room = std::max(0.08 * std::log10(*most / *least), 0.25 - 0.5 * std::log10(*most / *least));
    return {*least * std::pow(10.0, -std::max(room, 0.05)), *most * std::pow(10.0, std::max(room, 0.05)), true};
}

struct Axes {
    ValueRange time, error;
    glm::dvec2 at(double time_s, double error_percent) const {
        return low + (high - low) * glm::dvec2(time.position(time_s), error.position(error_percent));
    }
};

void draw_axes(const Axes& axes, Drawing& d) {
    for (const Tick& tick : round_ticks(axes.time, 8)) {
        const double x = axes.at(tick.value, axes.error.low).x;
        d.lines.push_back({{x, low.y}, {x, high.y}, 1, Pen::grid});
        d.texts.push_back({{x, low.y + 20}, tick.label, letters, Anchor::middle});
    }
    for (const Tick& tick : round_ticks(axes.error, 8)) {
        const double y = axes.at(axes.time.low, tick.value).y;
        d.lines.push_back({{low.x, y}, {high.x, y}, 1, Pen::grid});
        d.texts.push_back({{low.x - 10, y}, tick.label, letters, Anchor::end});
    }
    const glm::dvec2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}, low};
    for (int i = 0; i < 4; ++i) d.lines.push_back({corners[i], corners[i + 1], 1.5, Pen::ink});
    d.texts.push_back({{(low.x + high.x) / 2, low.y + 50}, "Time of the run, s", letters, Anchor::middle});
    d.texts.push_back({{low.x - 75, (low.y + high.y) / 2}, "Error, % (relative RMSE)", letters, Anchor::middle, true});
}

}  // namespace

Drawing plot_of(const Table& table) {
    Drawing d{width, height, {}, {}, {}};
    d.texts.push_back({{low.x, high.y - 28},
                       fmt::format("Sweep of {}", table.scenario.filename().string()),
                       letters + 2,
                       Anchor::start,
                       false,
                       true});
    std::vector<double> times, errors;
    for (const CostAndError& c : table.costs) {
        if (!is_drawn(c)) continue;
        times.push_back(c.time_s);
        errors.push_back(100 * c.error);
    }
    if (times.empty()) return d;
    if (table.tolerance) errors.push_back(100 * *table.tolerance);
    const Axes axes{range_of(times), range_of(errors)};
    draw_axes(axes, d);
    const auto place = [&](std::size_t i) { return axes.at(table.costs[i].time_s, 100 * table.costs[i].error); };
    if (table.tolerance) {
        const double y = axes.at(axes.time.low, 100 * *table.tolerance).y;
        d.lines.push_back({{low.x, y}, {high.x, y}, 2, Pen::limit, true});
        d.texts.push_back({{high.x - 8, y - 14}, "asked for", letters, Anchor::end});
    }
    for (std::size_t i = 0; i < table.costs.size(); ++i)
        if (is_drawn(table.costs[i])) d.discs.push_back({place(i), 4.5, Pen::mark});
    if (table.tolerance) {
        if (const auto cheapest = cheapest_within(table.costs, *table.tolerance);
            cheapest && is_drawn(table.costs[*cheapest]))
            d.discs.push_back({place(*cheapest), 10, Pen::limit});
    }
    const std::size_t* before = nullptr;
    for (const std::size_t& i : table.front) {
        if (!is_drawn(table.costs[i])) continue;
        if (before) d.lines.push_back({place(*before), place(i), 2, Pen::accent});
        before = &i;
        d.discs.push_back({place(i), 6, Pen::accent});
        d.texts.push_back({place(i) + glm::dvec2(9, -13), fmt::format("#{}", table.rows[i].number), letters - 2});
    }
    return d;
}

}  // namespace waterlight
