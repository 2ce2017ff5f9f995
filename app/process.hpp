// Other runs of this program, as processes of their own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace waterlight {

struct ChildResult {
    int exit = -1;   ///< -1: it did not exit by itself
    int signal = 0;  ///< that ended it, where one did
    double wall_s = 0;
};

/// Runs this very program with `arguments` and waits for it; what it says goes to `log`. It ends with the thread that
/// called. May be called from several threads at once. Throws WorldError where it cannot be started.
ChildResult run_child(const std::vector<std::string>& arguments, const std::filesystem::path& log);

/// Words of a shell: those with other characters than a file's name usually has are quoted.
std::string shell_text(const std::vector<std::string>& words);

}  // namespace waterlight
