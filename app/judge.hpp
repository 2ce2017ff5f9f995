// What a check says about a value.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scenarios/scenario.hpp"

namespace waterlight {

struct CheckResult {
    int check = 0;  ///< its index in the scenario
    std::string name;
    double value = 0;
    std::string expected;  ///< "= 850", "< 0.001"
    double tolerance = 0;
    bool pass = false;
    bool is_left = false;  ///< to the command `check`, which makes the other runs that it takes
};

/// One result for each bound that a check states; `values` are those of the checks, in their order. A value that is not
/// a number fails.
std::vector<CheckResult> judge(const std::vector<Check>& checks, std::span<const double> values);

/// "floor.cv over 2 to 4 s": the quantity with what the check says about its time and its reference.
std::string name_of(const Check& check);

}  // namespace waterlight
