// The outcome of `check` as JUnit XML, as continuous integration reads it: a testsuite for each scenario, a testcase
// for each bound of each check.
#pragma once

#include <string>
#include <vector>

#include "app/check_outcome.hpp"
#include "app/check_plan.hpp"

namespace waterlight {

/// Well-formed whatever the texts contain.
std::string junit_xml(const std::vector<CheckItem>& items, const std::vector<ItemOutcome>& outcomes,
                      const CheckOptions& options, double wall_s);

}  // namespace waterlight
