// ledger.csv: where the light of each frame went.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "caustics/light_ledger.hpp"

namespace waterlight {

/// The columns of one ledger, of what followed the light: "floor.incident_w", ..., "floor.closure".
std::vector<std::string> ledger_columns(const std::string& follower);
/// The values of these columns, of all ledgers one after the other.
std::vector<double> ledger_row(std::span<const LightLedger> ledgers);

}  // namespace waterlight
