// Runs the program as a user does.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace waterlight::test {

struct Outcome {
    int exit = -1;       ///< -1: it did not exit by itself
    std::string output;  ///< stdout and stderr
};

/// As one word of a shell.
inline std::string quoted(const std::string& argument) {
    std::ostringstream text;
    text << "'";
    for (const char c : argument) {
        if (c == '\'')
            text << "'\\''";
        else
            text << c;
    }
    text << "'";
    return text.str();
}

/// `environment` is put before the command, as in "NAME=value".
inline Outcome run_program(const std::vector<std::string>& arguments, const std::string& environment = "") {
    std::ostringstream command;
    command << environment << ' ' << quoted(WATERLIGHT_PROGRAM);
    for (const std::string& argument : arguments) command << ' ' << quoted(argument);
    command << " 2>&1";
    std::FILE* pipe = popen(command.str().c_str(), "r");
    if (!pipe) throw std::runtime_error("popen failed");
    Outcome outcome;
    std::array<char, 4096> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
        outcome.output.append(buffer.data(), count);
    const int status = pclose(pipe);
    if (WIFEXITED(status)) outcome.exit = WEXITSTATUS(status);
    return outcome;
}

inline std::string read_file(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A folder of its own, removed at the end. Its name has a space in it, as users' folders do.
class Scratch {
  public:
    explicit Scratch(const std::string& name,
                     const std::filesystem::path& root = std::filesystem::temp_directory_path())
        : path_(root / ("waterlight test " + name + " " + std::to_string(getpid()))) {
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path_ / name;
    }

  private:
    std::filesystem::path path_;
};

}  // namespace waterlight::test
