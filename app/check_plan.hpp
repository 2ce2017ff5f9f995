// Which scenarios `check` runs, and which of their checks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/check.hpp"
#include "scenarios/scenario.hpp"

namespace waterlight {

/// One scenario under check.
struct CheckItem {
    std::filesystem::path file;
    std::string name;                    ///< the file's, without extension
    std::vector<std::string> overrides;  ///< its own under check, then those of the command line; later ones count
    std::optional<Scenario> scenario;    ///< none where it is wrong, or its data is absent
    std::vector<int> chosen;             ///< checks that the filter takes
    std::string wrong;                   ///< why it cannot be read; else empty
    std::string skipped;                 ///< why it is not run; else empty
    double memory_bytes = 0;             ///< predicted
};

/// In order of their paths. An item that the filter leaves without a check is left out. Throws InputError where a path
/// does not exist, a file states no check, or nothing is left.
std::vector<CheckItem> plan_checks(const CheckOptions& options);

/// What --filter matches.
std::string full_name(const CheckItem& item, const std::string& quantity);

}  // namespace waterlight
