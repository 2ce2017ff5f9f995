#include "tests/bench/accuracy/report.hpp"
#include "tests/bench/seconds_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace waterlight::accuracy {

namespace {

const Measured* cheapest(const std::vector<Measured>& all, double tolerance) {
    const Measured* best = nullptr;
    for (const Measured& m : all)
        if (m.error <= tolerance && (best == nullptr || m.cost < best->cost)) best = &m;
    return best;
}

}  // namespace

void print_row(const std::vector<std::string>& cells) {
    for (const std::string& cell : cells) fmt::print("| {} ", cell);
    fmt::print("|\n");
    std::fflush(stdout);
}

void print_heads(const std::vector<std::string>& heads) {
    fmt::print("\n");
    print_row(heads);
    print_row(std::vector<std::string>(heads.size(), "---:"));
}

std::string digits(double value) {
    if (value < 99.5 || !std::isfinite(value)) return fmt::format("{:.2g}", value);
    const double last = std::pow(10, std::floor(std::log10(value)) - 1);
    return fmt::format("{:.0f}", last * std::round(value / last));
}

std::string percent(double part) { return digits(100 * part) + " %"; }

std::vector<Timed> time_together(const Options& options, const std::vector<std::function<void()>>& works,
                                 double budget_s) {
    constexpr int least_rounds = 4, most_rounds = 25;
    constexpr double never = std::numeric_limits<double>::infinity();
    std::vector<double> fastest(works.size(), never);
    double yardstick_s = never, spent = 0;
    for (int round = 0; round < least_rounds || (spent < budget_s && round < most_rounds); ++round) {
        const auto call = [&](const std::function<void()>& work, double& least) {
            const double s = seconds_of(work);
            spent += s;
            if (round > 0) least = std::min(least, s);
        };
        for (std::size_t k = 0; k < works.size(); ++k) {
            call(works[k], fastest[k]);
            if (k > 0) call(works[0], fastest[0]);
            call(options.yardstick, yardstick_s);
        }
    }
    std::vector<Timed> times;
    for (const double s : fastest) times.push_back({1e3 * s, s / fastest.front(), yardstick_pixels * s / yardstick_s});
    return times;
}

double relative_rms(const Field<double>& found, const Field<double>& exact) {
    double difference = 0, square = 0;
    for (int j = 0; j < exact.ny(); ++j) {
        for (int i = 0; i < exact.nx(); ++i) {
            const double d = found(i, j) - exact(i, j);
            difference += d * d;
            square += exact(i, j) * exact(i, j);
        }
    }
    return std::sqrt(difference / square);
}

double order_of(const std::vector<int>& resolutions, const std::vector<double>& errors) {
    const double n = static_cast<double>(resolutions.size());
    double x_sum = 0, y_sum = 0, xx = 0, xy = 0;
    for (std::size_t k = 0; k < resolutions.size(); ++k) {
        const double x = std::log(double(resolutions[k])), y = std::log(errors[k]);
        x_sum += x;
        y_sum += y;
        xx += x * x;
        xy += x * y;
    }
    return -(n * xy - x_sum * y_sum) / (n * xx - x_sum * x_sum);
}

void Choices::add(const std::string& scene, Measured measured) {
    auto at = std::find_if(scenes_.begin(), scenes_.end(), [&](const Scene& s) { return s.name == scene; });
    if (at == scenes_.end()) at = scenes_.insert(at, {scene, {}});
    at->measured.push_back(std::move(measured));
}

void Choices::print() const {
    const std::vector<double> tolerances{.1, .03, .01, .003, .001};
    std::vector<std::string> heads{"scene"};
    for (const double t : tolerances) heads.push_back(fmt::format("{:g} %", 100 * t));
    print_heads(heads);
    for (const Scene& scene : scenes_) {
        std::vector<std::string> cells{scene.name};
        for (const double t : tolerances) {
            const Measured* best = cheapest(scene.measured, t);
            cells.push_back(best != nullptr ? fmt::format("{}: {}", best->setting, digits(best->cost))
                                            : "none measured");
        }
        print_row(cells);
    }
}

}  // namespace waterlight::accuracy
