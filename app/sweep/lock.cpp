#include "app/sweep/lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "export/atomic_file.hpp"

namespace waterlight {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
    throw_cannot_write(path, std::generic_category().message(errno));
}

int open_file(const std::filesystem::path& path) {
    std::error_code ignored;
    std::filesystem::create_directories(path.parent_path(), ignored);
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0) fail(path);
    return file;
}

}  // namespace

FileLock::FileLock(std::filesystem::path path) : FileLock(path, open_file(path)) {
    while (::flock(file_, LOCK_EX) != 0)
        if (errno != EINTR) fail(path_);
}

std::unique_ptr<FileLock> FileLock::try_for(std::filesystem::path path) {
    const int file = open_file(path);
    if (::flock(file, LOCK_EX | LOCK_NB) == 0) return std::unique_ptr<FileLock>(new FileLock(std::move(path), file));
    const bool is_taken = errno == EWOULDBLOCK;
    ::close(file);
    if (is_taken) return nullptr;
    fail(path);
}

FileLock::~FileLock() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
    ::close(file_);
}

}  // namespace waterlight
