// One run: a scenario from its file to its outputs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/floor_stage.hpp"

namespace waterlight {

struct RunOptions {
    std::filesystem::path scenario;
    std::filesystem::path out;  ///< empty: out/<stem of the scenario>
    std::vector<std::string> overrides;
    DeviceWish device;
    bool quiet = false;
};

/// Runs and writes everything. Returns whether all checks of the scenario passed. Throws InputError before anything is
/// written, WorldError and gpu::Error at any time.
bool run_scenario(const RunOptions& options);

}  // namespace waterlight
