// The program as a process that goes on beside the test: to be watched, signalled and killed.
#pragma once

#include <fcntl.h>
#include <linux/capability.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tests/scenarios/program.hpp"

namespace waterlight::test {

/// What a process may do.
struct ChildLimits {
    std::optional<rlim_t> file_bytes;      ///< RLIMIT_FSIZE
    std::optional<rlim_t> address_bytes;   ///< RLIMIT_AS
    bool obeys_permissions = false;        ///< root, too, writes only where files and folders say so
    std::vector<std::string> environment;  ///< "NAME=value"
};

class Child {
  public:
    /// Starts it; stdout and stderr go to `output`.
    Child(std::vector<std::string> arguments, std::filesystem::path output, const ChildLimits& limits = {})
        : output_(std::move(output)) {
        arguments.insert(arguments.begin(), WATERLIGHT_PROGRAM);
        std::vector<char*> argv;
        for (std::string& argument : arguments) argv.push_back(argument.data());
        argv.push_back(nullptr);
        process_ = ::fork();
        if (process_ == 0) become(argv.data(), limits);
    }
    ~Child() {
        if (process_ > 0) kill(SIGKILL);
        wait();
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    pid_t process() const { return process_; }
    void kill(int signal) const { ::kill(process_, signal); }

    /// Until it ends. Its exit status, or minus the signal that ended it.
    int wait() {
        if (process_ > 0) {
            int status = 0;
            ::waitpid(process_, &status, 0);
            exit_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
            process_ = -1;
        }
        return exit_;
    }
    std::string output() const { return read_file(output_); }

  private:
    [[noreturn]] void become(char** argv, const ChildLimits& limits) const {
        const int to = ::open(output_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
        ::dup2(to, STDOUT_FILENO);
        ::dup2(to, STDERR_FILENO);
        for (const std::string& variable : limits.environment) {
            const std::size_t end = variable.find('=');
            ::setenv(variable.substr(0, end).c_str(), variable.substr(end + 1).c_str(), 1);
        }
        const auto limit = [](int resource, const std::optional<rlim_t>& most) {
            const rlimit both{most.value_or(0), most.value_or(0)};
            if (most) ::setrlimit(static_cast<__rlimit_resource>(resource), &both);
        };
        limit(RLIMIT_FSIZE, limits.file_bytes);
        limit(RLIMIT_AS, limits.address_bytes);
        const bool is_bound =
            !limits.obeys_permissions || ::geteuid() != 0 || ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0) == 0;
        if (is_bound) ::execv(argv[0], argv);
        ::_exit(127);
    }

    std::filesystem::path output_;
    pid_t process_ = -1;
    int exit_ = 0;
};

/// Where files are quickly on the disk: in memory, if the system has such a place. Checkpoints wait for the disk.
inline std::filesystem::path quick_place() {
    const std::filesystem::path memory = "/dev/shm";
    return ::access(memory.c_str(), W_OK) == 0 ? memory : std::filesystem::temp_directory_path();
}

/// Waits until `holds`, at most a minute. Returns whether it came to hold.
template <class Holds>
bool wait_until(Holds holds) {
    for (int n = 0; n < 60000; ++n) {
        if (holds()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

}  // namespace waterlight::test
