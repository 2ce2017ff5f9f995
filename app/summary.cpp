#include "app/summary.hpp"

#include <fmt/format.h>

namespace waterlight {

namespace {

std::string text_of(const CheckResult& check) {
    if (check.is_left)
        return fmt::format("check left to `waterlight check`, which makes other runs: {}, expected {}", check.name,
                           check.expected);
    const std::string within = check.tolerance > 0 ? fmt::format(" within {:.3g}", check.tolerance) : "";
    return fmt::format("check {}: {} is {:.6g}, expected {}{}", check.pass ? "passed" : "FAILED", check.name,
                       check.value, check.expected, within);
}

}  // namespace

void print_summary(const Scenario& scenario, const BackendDecision& backend, const RunRecord& record,
                   std::span<const CheckResult> checks, std::span<const std::string> guide) {
    fmt::print("{}: {} frame{}, {:.4g} s of water in {:.1f} s, model {}, back-end {}\n",
               scenario.title.empty() ? scenario.origin.file.string() : scenario.title, record.frames,
               record.frames == 1 ? "" : "s", record.simulated_s, record.wall.total, record.waves.model,
               backend.backend == Backend::vulkan ? "vulkan on " + backend.device : "cpu");
    for (const CheckResult& check : checks) fmt::print("{}\n", text_of(check));
    for (const std::string& line : guide) fmt::print("{}\n", line);
}

void print_failures(std::span<const CheckResult> checks) {
    for (const CheckResult& check : checks)
        if (!check.pass && !check.is_left) fmt::print(stderr, "{}\n", text_of(check));
}

}  // namespace waterlight
