#include "sim/file_stamp.hpp"

#include <sys/stat.h>

namespace waterlight {

FileStamp stamp_of(const std::filesystem::path& file) {
    struct stat found {};
    if (::stat(file.c_str(), &found) != 0) return {};
    constexpr std::int64_t second_ns = 1'000'000'000;
    return {found.st_size, found.st_mtim.tv_sec * second_ns + found.st_mtim.tv_nsec, found.st_ino};
}

}  // namespace waterlight
