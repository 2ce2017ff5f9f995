#include "app/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

#include "app/timed.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

constexpr const char* this_program = "/proc/self/exe";
constexpr int cannot_start = 127;
constexpr double grace_s = 2;  // from SIGTERM to SIGKILL

using Clock = std::chrono::steady_clock;

[[noreturn]] void throw_failed(const char* what) {
    throw WorldError(fmt::format("cannot {} a run: {}", what, std::strerror(errno)));
}

/// After fork(): only calls that are safe in a copy of a process with threads.
[[noreturn]] void become(char* const* arguments, const char* log) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    const int file = open(log, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (file >= 0 && dup2(file, STDOUT_FILENO) >= 0 && dup2(file, STDERR_FILENO) >= 0) execv(this_program, arguments);
    _exit(cannot_start);
}

/// Whether and why a run must not go on.
ChildEnd end_of(const ChildBounds& bounds, double wall_s) {
    if (bounds.stop_signal && bounds.stop_signal() != 0) return ChildEnd::stopped;
    return wall_s >= bounds.most_s ? ChildEnd::too_long : ChildEnd::by_itself;
}

/// Waits until the child has ended, and sees to it that it does; returns its status. Threads that wait are many and a
/// signal wakes one of them, so each looks for itself.
int wait_for(pid_t child, Clock::time_point start, const ChildBounds& bounds, ChildEnd& end) {
    constexpr std::chrono::milliseconds between_looks{5};
    double asked_s = 0;
    bool is_killed = false;
    for (int status = 0;;) {
        const pid_t ended = waitpid(child, &status, WNOHANG);
        if (ended == child) return status;
        if (ended < 0 && errno != EINTR) throw_failed("wait for");
        const double now_s = seconds_since(start);
        if (end == ChildEnd::by_itself) {
            end = end_of(bounds, now_s);
            asked_s = now_s;
            if (end != ChildEnd::by_itself) kill(child, SIGTERM);
        } else if (!is_killed && now_s - asked_s > grace_s) {
            kill(child, SIGKILL);
            is_killed = true;
        }
        std::this_thread::sleep_for(between_looks);
    }
}

}  // namespace

ChildResult run_child(const std::vector<std::string>& arguments, const std::filesystem::path& log,
                      const ChildBounds& bounds) {
    ChildResult result;
    result.end = end_of(bounds, 0);
    if (result.end != ChildEnd::by_itself) return result;
    std::vector<std::string> words{"waterlight"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const Clock::time_point start = Clock::now();
    const pid_t child = fork();
    if (child < 0) throw_failed("start");
    if (child == 0) become(pointers.data(), log.c_str());
    const int status = wait_for(child, start, bounds, result.end);
    result.wall_s = seconds_since(start);
    if (WIFEXITED(status)) result.exit = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
    if (result.exit == cannot_start)
        throw WorldError(fmt::format("cannot start a run of this program that writes to {}", log.string()));
    return result;
}

std::string shell_text(const std::vector<std::string>& words) {
    const auto is_plain = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || std::strchr("_-./=:,+@%", c) != nullptr;
    };
    std::string text;
    for (const std::string& word : words) {
        if (!text.empty()) text += ' ';
        if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) {
            text += word;
            continue;
        }
        text += '\'';
        for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
        text += '\'';
    }
    return text;
}

}  // namespace waterlight
