// Makes the runs that the checks of one scenario need, and judges them.
#pragma once

#include <filesystem>

#include "app/check_outcome.hpp"
#include "app/check_plan.hpp"

namespace waterlight {

/// `out` is the folder of this scenario's runs, `threads` those of the CPU that each may use. May be called from
/// several threads at once. Throws WorldError where no run can be started.
ItemOutcome run_item(const CheckItem& item, const CheckOptions& options, const std::filesystem::path& out, int threads);

}  // namespace waterlight
