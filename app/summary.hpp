// What a run says on the terminal when it is done.
#pragma once

#include <span>
#include <string>

#include "app/report.hpp"

namespace waterlight {

/// To stdout: what ran, the outcome of each check, and `guide`, where the files are.
void print_summary(const Scenario& scenario, const BackendDecision& backend, const RunRecord& record,
                   std::span<const CheckResult> checks, std::span<const std::string> guide);

/// To stderr: the checks that failed.
void print_failures(std::span<const CheckResult> checks);

}  // namespace waterlight
