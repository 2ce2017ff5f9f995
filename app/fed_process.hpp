// Another program that reads what this one writes to it.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace waterlight {

/// The program of that name in $PATH; none where there is none that may be run.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// Runs without a shell. It ends with the thread that made it, and does not hear the terminal's Ctrl-C.
class FedProcess {
  public:
    /// Throws WorldError where it cannot be started.
    FedProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments);
    /// Ends it where it still runs.
    ~FedProcess();
    FedProcess(const FedProcess&) = delete;
    FedProcess& operator=(const FedProcess&) = delete;

    /// Waits until all of it has been taken; false where the program reads no more.
    bool write(std::string_view bytes);
    /// Ends its input and waits for it. Returns whether it exited with 0.
    bool finish();
    /// What it has said on stdout and stderr.
    std::string said() const;

  private:
    int input_ = -1, log_ = -1;
    pid_t process_ = -1;
};

}  // namespace waterlight
