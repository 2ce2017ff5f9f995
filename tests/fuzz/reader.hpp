// What every fuzz target shares. A target reads one input that may hold anything: it must give a result, or an
// InputError or WorldError of one printable line. Anything else is a finding: another exception, a signal, a
// sanitizer's report, a hang, memory beyond bounds.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "sim/error.hpp"

namespace waterlight::fuzz {

inline void require_one_line(std::string_view message) {
    constexpr std::size_t longest = 2000;  // whatever the input holds
    bool good = !message.empty() && message.size() <= longest;
    for (const char c : message) good = good && static_cast<unsigned char>(c) >= 0x20 && c != 0x7f;
    if (good) return;
    std::fprintf(stderr, "this error is not one printable line: \"%.*s\"\n",
                 static_cast<int>(std::min(message.size(), longest)), message.data());
    std::abort();
}

/// Runs `read`, content with a result or a proper error.
template <class Read>
void expect_result_or_error(Read read) {
    try {
        read();
    } catch (const InputError& error) {
        require_one_line(error.what());
    } catch (const WorldError& error) {
        require_one_line(error.what());
    }
}

/// In memory where there is such a folder.
inline std::filesystem::path fast_folder() {
    const std::filesystem::path memory = "/dev/shm";
    return std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
}

/// A file of this process alone that readers of paths are given.
class InputFile {
  public:
    explicit InputFile(const std::string& ending)
        : folder_(fast_folder() / ("waterlight_fuzz_" + std::to_string(::getpid()))),
          path_(folder_ / ("input" + ending)) {
        std::filesystem::create_directories(folder_);
    }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;
    ~InputFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
        std::filesystem::remove(folder_, ignored);
    }

    const std::filesystem::path& path() const { return path_; }
    void write(std::string_view bytes) const {
        std::ofstream(path_, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }

  private:
    std::filesystem::path folder_, path_;
};

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

}  // namespace waterlight::fuzz

/// The entry that libFuzzer and replay.cpp call; returns 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
