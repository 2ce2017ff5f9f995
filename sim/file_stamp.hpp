// Whether a file is still the one that it was.
#pragma once

#include <cstdint>
#include <filesystem>

namespace waterlight {

struct FileStamp {
    std::int64_t bytes = -1;  ///< -1: there is no such file
    std::int64_t changed_ns = 0;
    std::uint64_t inode = 0;  ///< another one where a file was put in its place
    bool operator==(const FileStamp&) const = default;
};

FileStamp stamp_of(const std::filesystem::path& file);

}  // namespace waterlight
