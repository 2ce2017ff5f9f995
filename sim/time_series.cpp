#include "sim/time_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/text_file.hpp"

namespace waterlight {

namespace {

/// What a line holds: time and value, or nothing where it is part of a heading, a comment or blank.
std::optional<std::pair<double, double>> pair_in(std::string_view line, const TextFile& file, bool in_heading) {
    if (is_blank(line) || line.starts_with('#')) return {};
    const std::optional<LineOfNumbers> numbers = numbers_in(line);
    if (!numbers && in_heading) return {};
    if (!numbers || numbers->count != 2) {
        file.fail(fmt::format("two numbers are wanted, time (s) and value; found {}", quoted(line)));
    }
    return std::pair{numbers->values[0], numbers->values[1]};
}

}  // namespace

double TimeSeries::at(double t_s) const {
    const auto later = std::ranges::upper_bound(time_s, t_s);
    if (later == time_s.begin()) return value.front();
    if (later == time_s.end()) return value.back();
    const auto next = static_cast<std::size_t>(later - time_s.begin());
    const double part = (t_s - time_s[next - 1]) / (time_s[next] - time_s[next - 1]);
    return std::lerp(value[next - 1], value[next], part);
}

double TimeSeries::rate_at(double t_s) const {
    const auto later = std::ranges::upper_bound(time_s, t_s);
    if (later == time_s.begin() || later == time_s.end()) return 0;
    const auto next = static_cast<std::size_t>(later - time_s.begin());
    return (value[next] - value[next - 1]) / (time_s[next] - time_s[next - 1]);
}

TimeSeries constant_series(double value) { return {{0}, {value}}; }

TimeSeries read_time_series(const std::filesystem::path& path, double scale) {
    TextFile file(path);
    TimeSeries series;
    while (const auto line = file.next_line()) {
        const auto pair = pair_in(*line, file, series.empty());
        if (!pair) continue;
        const auto [time_s, value] = *pair;
        if (!std::isfinite(time_s) || !std::isfinite(scale * value)) {
            file.fail(
                fmt::format("finite numbers are wanted; found time {:g} s and value {:g}", time_s, scale * value));
        }
        if (!series.empty() && time_s <= series.end_s()) {
            file.fail(fmt::format("times must increase; found {} s after {} s", time_s, series.end_s()));
        }
        series.time_s.push_back(time_s);
        series.value.push_back(scale * value);
    }
    if (series.empty()) file.reject("holds no line of two numbers, time (s) and value");
    return series;
}

}  // namespace waterlight
