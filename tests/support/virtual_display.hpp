// A screen of its own for a test: an X server that draws into a file.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace waterlight::test {

/// A picture of the screen: red, green and blue of each pixel, rows from the top down.
struct Screen {
    int width = 0, height = 0;
    std::vector<std::array<std::uint8_t, 3>> pixels;
    const std::array<std::uint8_t, 3>& at(int x, int y) const {
        return pixels.at(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    }
};

/// Starts Xvfb on a free display of 1280 x 800 pixels and points $DISPLAY at it, until its end.
class VirtualDisplay {
  public:
    static bool is_installed() { return ::access("/usr/bin/Xvfb", X_OK) == 0; }

    VirtualDisplay()
        : folder_(std::filesystem::temp_directory_path() / ("waterlight screen " + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder_);
        std::array<int, 2> told{};
        if (::pipe(told.data()) != 0) return;
        server_ = ::fork();
        if (server_ == 0) become(told[1]);
        ::close(told[1]);
        std::string number;
        for (char c = 0; ::read(told[0], &c, 1) == 1 && c != '\n';) number += c;
        ::close(told[0]);
        ::setenv("DISPLAY", (":" + number).c_str(), 1);
    }
    ~VirtualDisplay() {
        ::unsetenv("DISPLAY");
        ::kill(server_, SIGTERM);
        ::waitpid(server_, nullptr, 0);
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;

    /// What is on it now. The file is an X window dump: numbers of 4 bytes, highest first, then colours, then pixels of
    /// blue, green, red and nothing.
    Screen screen() const {
        std::ifstream file(folder_ / "Xvfb_screen0", std::ios::binary);
        std::array<std::array<std::uint8_t, 4>, 25> header{};
        file.read(reinterpret_cast<char*>(header.data()), sizeof(header));
        const auto number = [&](std::size_t i) {
            return header[i][0] << 24 | header[i][1] << 16 | header[i][2] << 8 | header[i][3];
        };
        constexpr int colour_bytes = 12;
        file.seekg(number(0) + colour_bytes * number(19));
        Screen screen{number(4), number(5), {}};
        std::vector<std::array<std::uint8_t, 4>> dumped(static_cast<std::size_t>(screen.width) *
                                                        static_cast<std::size_t>(screen.height));
        file.read(reinterpret_cast<char*>(dumped.data()), static_cast<std::streamsize>(4 * dumped.size()));
        for (const auto& pixel : dumped) screen.pixels.push_back({pixel[2], pixel[1], pixel[0]});
        return screen;
    }

  private:
    [[noreturn]] void become(int told) const {
        const std::string to = std::to_string(told), folder = folder_.string();
        const int nothing = ::open("/dev/null", O_WRONLY);
        ::dup2(nothing, STDERR_FILENO);
        ::execl("/usr/bin/Xvfb", "Xvfb", "-displayfd", to.c_str(), "-screen", "0", "1280x800x24", "-fbdir",
                folder.c_str(), "-nolisten", "tcp", "-noreset", nullptr);
        ::_exit(127);
    }

    std::filesystem::path folder_;
    pid_t server_ = -1;
};

}  // namespace waterlight::test
