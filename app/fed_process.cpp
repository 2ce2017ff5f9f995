#include "app/fed_process.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "sim/error.hpp"

namespace waterlight {

namespace {

namespace fs = std::filesystem;

/// After fork(): only calls that are safe in a copy of a process with threads.
[[noreturn]] void become(const char* program, char* const* arguments, int input, int log) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    setpgid(0, 0);
    if (dup2(input, STDIN_FILENO) >= 0 && dup2(log, STDOUT_FILENO) >= 0 && dup2(log, STDERR_FILENO) >= 0)
        execv(program, arguments);
    _exit(127);
}

}  // namespace

std::optional<fs::path> find_program(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const fs::path file = fs::path(folder.empty() ? "." : folder) / name;
        std::error_code ignored;
        if (fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0) return file;
    }
    return std::nullopt;
}

FedProcess::FedProcess(const fs::path& program, const std::vector<std::string>& arguments) {
    std::vector<std::string> words{program.filename().string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    // A socket, for writing to a pipe that nobody reads would raise SIGPIPE.
    std::array<int, 2> ends{-1, -1};
    log_ = memfd_create("waterlight", MFD_CLOEXEC);
    if (log_ >= 0 && socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0) process_ = fork();
    if (process_ == 0) become(program.c_str(), pointers.data(), ends[0], log_);
    if (ends[0] >= 0) close(ends[0]);
    input_ = ends[1];
    if (process_ < 0) throw WorldError(fmt::format("cannot start {}: {}", program.string(), std::strerror(errno)));
}

FedProcess::~FedProcess() {
    if (input_ >= 0) close(input_);
    if (process_ > 0) {
        kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }
    if (log_ >= 0) close(log_);
}

bool FedProcess::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

bool FedProcess::finish() {
    close(input_);
    input_ = -1;
    int status = 0;
    while (waitpid(process_, &status, 0) < 0)
        if (errno != EINTR) return false;
    process_ = -1;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string FedProcess::said() const {
    std::string text;
    std::array<char, 4096> part{};
    for (ssize_t count = 0; (count = pread(log_, part.data(), part.size(), static_cast<off_t>(text.size()))) > 0;)
        text.append(part.data(), static_cast<std::size_t>(count));
    return text;
}

}  // namespace waterlight
