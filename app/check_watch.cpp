#include "app/check_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/probe_spectrum.hpp"
#include "app/readings.hpp"
#include "scenarios/quantities.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

constexpr double time_slack = 1e-9;  // relative: times that are one but for rounding

bool is_series(const Check& check) { return kind_of(check.quantity) == QuantityKind::of_series; }
bool is_of_rows(const Check& check) { return is_series(check) || (check.window_s && is_row_quantity(check.quantity)); }

/// NAME of probe.NAME.quantity.
std::string probe_of(const std::string& quantity) {
    const std::size_t first = quantity.find('.') + 1;
    return quantity.substr(first, quantity.rfind('.') - first);
}

/// Means weigh every value the same.
double taken_together(const std::vector<double>& values, const std::optional<Over>& over) {
    if (values.empty()) return no_value;
    double sum = 0, squares = 0, low = values.front(), high = values.front();
    for (const double v : values) {
        sum += v;
        squares += v * v;
        low = std::min(low, v);
        high = std::max(high, v);
    }
    const double n = static_cast<double>(values.size());
    if (std::isnan(sum)) return no_value;
    if (!over) return sum / n;
    return *over == Over::min ? low : *over == Over::max ? high : std::sqrt(squares / n);
}

}  // namespace

CheckWatch::CheckWatch(const Scenario& scenario) : scenario_(scenario), seen_(scenario.checks.size()) {}

bool CheckWatch::is_in(const Check& check, double time_s) const {
    const double end = scenario_.waves.duration_s, room = time_slack * std::max(1.0, end);
    if (is_series(check) && !check.window_s) return time_s <= check.at_s.value_or(end) + room;
    if (check.window_s) return time_s >= check.window_s->x - room && time_s <= check.window_s->y + room;
    return std::abs(time_s - check.at_s.value_or(end)) <= room;
}

bool CheckWatch::wants(double time_s) const {
    return std::any_of(scenario_.checks.begin(), scenario_.checks.end(),
                       [&](const Check& check) { return !is_of_rows(check) && is_in(check, time_s); });
}

void CheckWatch::add_row(double time_s, const std::map<std::string, ProbeRecord>& probes) {
    for (std::size_t i = 0; i < seen_.size(); ++i) {
        const Check& check = scenario_.checks[i];
        if (!is_of_rows(check) || !is_in(check, time_s)) continue;
        seen_[i].times_s.push_back(time_s);
        seen_[i].values.push_back(probes.at(probe_of(check.quantity)).elevation);
    }
}

void CheckWatch::add_frame(double time_s, const std::map<std::string, double>& quantities, const FrameFields& fields) {
    for (std::size_t i = 0; i < seen_.size(); ++i) {
        const Check& check = scenario_.checks[i];
        if (is_of_rows(check) || check.is_against_scenario() || !is_in(check, time_s)) continue;
        const auto found = quantities.find(check.quantity);
        double value = found == quantities.end() ? no_value : found->second;
        if (field_statistic(check.quantity)) value = field_value(scenario_, check, time_s, fields);
        seen_[i].times_s.push_back(time_s);
        seen_[i].values.push_back(value);
    }
}

void CheckWatch::require_references(const FrameFields& fields) const {
    for (std::size_t i = 0; i < seen_.size(); ++i) {
        const Check& check = scenario_.checks[i];
        if (!check.reference || check.is_against_scenario()) continue;
        scenario_.origin.in_place(fmt::format("check[{}].reference", i), [&] {
            field_value(scenario_, check, check.at_s.value_or(scenario_.waves.duration_s), fields);
        });
    }
}

void CheckWatch::exchange_state(StateArchive& state) {
    for (Seen& seen : seen_) {
        state.list(seen.times_s);
        state.list(seen.values);
    }
}

double CheckWatch::value_of(const Check& check, const Seen& seen) const {
    if (!is_series(check)) return taken_together(seen.values, check.over);
    if (check.quantity.ends_with(".significant_height")) return significant_height(seen.values);
    // Rows between the even ones are those of frames that come when they must, as at the end.
    const double every = scenario_.output.probe_every_s.value_or(scenario_.output.every_s);
    std::vector<double> even;
    for (std::size_t n = 0; n < seen.values.size(); ++n) {
        const double due = seen.times_s.front() + static_cast<double>(even.size()) * every;
        if (std::abs(seen.times_s[n] - due) < 1e-6 * every) even.push_back(seen.values[n]);
    }
    return peak_period(even, every);
}

std::vector<double> CheckWatch::values() const {
    std::vector<double> values;
    for (std::size_t i = 0; i < seen_.size(); ++i) values.push_back(value_of(scenario_.checks[i], seen_[i]));
    return values;
}

std::vector<double> checked_times(const Scenario& scenario) {
    std::vector<double> times;
    for (const Check& check : scenario.checks)
        if (check.at_s) times.push_back(*check.at_s);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

}  // namespace waterlight
