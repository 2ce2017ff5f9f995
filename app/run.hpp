// One run: a scenario from its file to its outputs.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/floor_stage.hpp"
#include "app/signals.hpp"

namespace waterlight {

struct RunOptions {
    std::filesystem::path scenario;
    std::filesystem::path out;  ///< empty: out/<stem of the scenario>
    std::vector<std::string> overrides;
    DeviceWish device;
    bool resume = false;  ///< go on from the checkpoint in `out`, where there is one
    bool quiet = false;
    std::optional<std::filesystem::path> movie;  ///< of the pictures of the scene; an empty path: movie.mp4 in `out`
    double movie_speed = 1;                      ///< simulated seconds a second of it, > 0
    /// The signal that asks the run to stop after the frame at hand, 0 while there is none; empty: nothing does.
    std::function<int()> stop_signal;
};

/// Runs and writes everything. Returns whether all checks of the scenario passed. Throws InputError before anything is
/// written, or where `resume` finds the checkpoint of another run; WorldError and gpu::Error at any time, naming the
/// checkpoint to go on from once there are frames; Interrupted once its frames are whole and its checkpoint and report
/// are written.
bool run_scenario(const RunOptions& options);

}  // namespace waterlight
