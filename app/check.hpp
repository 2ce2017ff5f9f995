// The command `check`: scenarios with [[check]] entries as tests.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace waterlight {

struct CheckOptions {
    std::string program = "waterlight";        ///< how this program was called
    std::vector<std::filesystem::path> paths;  ///< scenarios, and folders that are searched for them
    std::string filter = "*";                  ///< of SCENARIO/QUANTITY, as a shell matches file names
    std::filesystem::path junit;               ///< empty: none is written
    std::filesystem::path out;                 ///< where the runs write; empty: a folder that is removed at the end
    int jobs = 0;                              ///< scenarios at once; 0: as many as there are threads
    int threads = 1;                           ///< of the CPU, for all of them together
    bool update = false;                       ///< write values found in place of those that equals expects
    bool quiet = false;                        ///< no progress
    double timeout_s = std::numeric_limits<double>::infinity();  ///< wall time that the runs of a scenario may take
    /// The signal that asks to stop, 0 while there is none; empty: nothing does.
    std::function<int()> stop_signal;
    std::string backend = "auto";
    std::vector<std::string> overrides;
};

/// The worst that happened.
enum class CheckExit { passed, failed, wrong_scenario, world_failed };

/// Reads every scenario, then runs those that are right, several at once within memory and threads, each as a process
/// of its own; prints a table, and for each failure what was expected, where, and the command that repeats it. Throws
/// InputError where a path leads to no scenario with a check, WorldError where an output cannot be written; Interrupted
/// where it was asked to stop, once its runs have ended and what they came to is printed.
CheckExit run_checks(const CheckOptions& options);

}  // namespace waterlight
