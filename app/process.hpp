// Other runs of this program, as processes of their own.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace waterlight {

/// What ends a run before it ends by itself: SIGTERM, and SIGKILL two seconds later where it has not ended by then.
struct ChildBounds {
    double most_s = std::numeric_limits<double>::infinity();  ///< wall time
    std::function<int()> stop_signal;  ///< not 0: this program was asked to stop; empty: nothing asks it
};

enum class ChildEnd { by_itself, too_long, stopped };

struct ChildResult {
    ChildEnd end = ChildEnd::by_itself;
    int exit = -1;   ///< -1: it did not exit by itself, or was not started
    int signal = 0;  ///< that ended it, where one did
    double wall_s = 0;
};

/// Runs this very program with `arguments` and waits for it; what it says goes to `log`. It ends with the thread that
/// called. Where its bounds are over before it starts it is not started. May be called from several threads at once.
/// Throws WorldError where it cannot be started.
ChildResult run_child(const std::vector<std::string>& arguments, const std::filesystem::path& log,
                      const ChildBounds& bounds = {});

/// Words of a shell: those with other characters than a file's name usually has are quoted.
std::string shell_text(const std::vector<std::string>& words);

}  // namespace waterlight
