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

#include "sim/error.hpp"

namespace waterlight {

namespace {

constexpr const char* this_program = "/proc/self/exe";
constexpr int cannot_start = 127;

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

}  // namespace

ChildResult run_child(const std::vector<std::string>& arguments, const std::filesystem::path& log) {
    std::vector<std::string> words{"waterlight"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const auto start = std::chrono::steady_clock::now();
    const pid_t child = fork();
    if (child < 0) throw_failed("start");
    if (child == 0) become(pointers.data(), log.c_str());
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) throw_failed("wait for");
    ChildResult result;
    result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
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
