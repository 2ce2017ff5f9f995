#include "app/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <filesystem>

namespace waterlight {

namespace {

/// The other runs of which this check needs some, in words.
std::string expected_of_runs(const Check& check) {
    if (check.order) return fmt::format("order >= {} over {}", check.order->at_least, check.order->key);
    if (check.agrees)
        return fmt::format("as by {}", check.agrees->backend == OtherBackend::vulkan ? "vulkan" : "the CPU");
    return {};
}

class Judgement {
  public:
    Judgement(int index, const Check& check, double value) : check_(check) {
        result_.check = index;
        result_.name = name_of(check);
        result_.value = value;
        result_.is_left = check.needs_more_runs();
    }

    std::vector<CheckResult> results() {
        const double value = result_.value;
        if (check_.equals) {
            const double size = std::abs(*check_.equals);
            const double tolerance = std::max(check_.tolerance, check_.relative_tolerance * size);
            add(fmt::format("= {}", *check_.equals), std::abs(value - *check_.equals) <= tolerance, tolerance);
        }
        if (check_.below) add(fmt::format("< {}", *check_.below), value < *check_.below);
        if (check_.above) add(fmt::format("> {}", *check_.above), value > *check_.above);
        if (check_.between) {
            const auto [low, high] = std::pair(check_.between->x, check_.between->y);
            add(fmt::format("in [{}, {}]", low, high), value >= low && value <= high);
        }
        if (check_.order || check_.agrees) add(expected_of_runs(check_), false);
        return std::move(results_);
    }

  private:
    void add(std::string expected, bool pass, double tolerance = 0) {
        results_.push_back(result_);
        results_.back().expected = std::move(expected);
        results_.back().tolerance = tolerance;
        results_.back().pass = pass && !result_.is_left;
    }

    const Check& check_;
    CheckResult result_;
    std::vector<CheckResult> results_;
};

std::string time_of(const Check& check) {
    if (check.at_s) return fmt::format(" at {} s", *check.at_s);
    if (!check.window_s) return {};
    constexpr const char* over[] = {"least", "greatest", "rms"};
    const std::string what = check.over ? fmt::format(", {}", over[static_cast<int>(*check.over)]) : "";
    return fmt::format(" over {} to {} s{}", check.window_s->x, check.window_s->y, what);
}

}  // namespace

std::string name_of(const Check& check) {
    const std::string file = std::filesystem::path(check.reference.value_or("")).filename().string();
    const std::string reference = check.reference ? fmt::format(" against {}", file) : "";
    return check.quantity + reference + time_of(check);
}

std::vector<CheckResult> judge(const std::vector<Check>& checks, std::span<const double> values) {
    assert(checks.size() == values.size());
    std::vector<CheckResult> results;
    for (std::size_t i = 0; i < checks.size(); ++i) {
        const std::vector<CheckResult> own = Judgement(static_cast<int>(i), checks[i], values[i]).results();
        results.insert(results.end(), own.begin(), own.end());
    }
    return results;
}

}  // namespace waterlight
