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

/// The numbers digit x 10^n within the range, n in steps of `stride`.
std::vector<Tick> decades(ValueRange range, const std::vector<double>& digits, int stride) {
    std::vector<Tick> ticks;
    const int first = static_cast<int>(std::floor(std::log10(range.low)));
    const int last = static_cast<int>(std::ceil(std::log10(range.high)));
    for (int n = first; n <= last; ++n) {
        if (n % stride != 0) continue;
        for (const double digit : digits) {
            const double value = digit * std::pow(10.0, n);
            if (value < range.low * (1 - 1e-9) || value > range.high * (1 + 1e-9)) continue;
            ticks.push_back({value, label(value, value, value)});
        }
    }
    return ticks;
}

std::vector<Tick> logarithmic_ticks(ValueRange range, int most) {
    const auto fits = [&](const std::vector<Tick>& ticks) {
        return !ticks.empty() && static_cast<int>(ticks.size()) <= most;
    };
    for (const std::vector<double>& digits : {std::vector<double>{1, 2, 5}, {1, 3}, {1}})
        if (std::vector<Tick> ticks = decades(range, digits, 1); fits(ticks)) return ticks;
    int stride = 2;
    while (static_cast<int>(decades(range, {1}, stride).size()) > most) ++stride;
    return decades(range, {1}, stride);
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
    // Within less than two octaves there may be no such number: the even ticks serve there too.
    if (range.logarithmic && range.high >= 4 * range.low) return logarithmic_ticks(range, most);
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
