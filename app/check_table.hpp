// What `check` prints.
#pragma once

#include <string>
#include <vector>

#include "app/check_outcome.hpp"
#include "app/check_plan.hpp"

namespace waterlight {

/// One line for each check, aligned.
std::string table_text(const std::vector<CheckItem>& items, const std::vector<ItemOutcome>& outcomes);
/// For each check that failed: value, expected, where, and the command that repeats it; then what was skipped and why,
/// and how many of each.
std::string summary_text(const std::vector<CheckItem>& items, const std::vector<ItemOutcome>& outcomes,
                         const CheckOptions& options, double wall_s);

/// "FAILED: value 1, expected = 2 within 0.1", of one line.
std::string failure_text(const CheckOutcome& outcome);
/// The command line that runs this check alone.
std::string repeat_command(const CheckItem& item, const std::string& quantity, const CheckOptions& options);

}  // namespace waterlight
