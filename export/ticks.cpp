#include "export/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace waterlight {

namespace {

/// A label in plain decimals between 1e-4 and 1e6, else with an exponent.
std::string label(double value, double step, double greatest) {
    if (greatest >= 1e6 || step < 1e-4) return fmt::format("{:.3g}", value);
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
    return fmt::format("{:.{}f}", value, decimals);
}

}  // namespace

Tick round_down(double value) {
    assert(value > 0);
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    double step = decade;
    for (const double digit : {2.0, 5.0, 10.0}) {
        if (digit * decade <= value * (1 + 1e-9)) step = digit * decade;
    }
    return {step, label(step, step, step)};
}

std::vector<Tick> round_ticks(ValueRange range, int most) {
    assert(range.low < range.high && most >= 2);
    // One step longer than round_down's digits allow is at most 2.5 times as long.
    double step = round_down((range.high - range.low) / most).value;
    const auto count = [&] { return std::floor(range.high / step + 1e-9) - std::ceil(range.low / step - 1e-9) + 1; };
    while (count() > most) step = round_down(2.5 * step).value;
    const double greatest = std::max(std::abs(range.low), std::abs(range.high));
    std::vector<Tick> ticks;
    const auto first = static_cast<long>(std::ceil(range.low / step - 1e-9));
    const auto last = static_cast<long>(std::floor(range.high / step + 1e-9));
    for (long n = first; n <= last; ++n) {
        const double value = static_cast<double>(n) * step;
        ticks.push_back({value, label(value, step, greatest)});
    }
    return ticks;
}

}  // namespace waterlight
