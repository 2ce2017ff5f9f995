#include "export/descriptor.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "export/atomic_file.hpp"

namespace waterlight {

Descriptor::Descriptor(const std::filesystem::path& file, std::filesystem::path reported_as, int flags)
    : reported_as_(std::move(reported_as)), fd_(::open(file.c_str(), flags | O_CLOEXEC, 0666)) {
    if (fd_ < 0) fail();
}

Descriptor::~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
}

void Descriptor::fail() const { throw_cannot_write(reported_as_, std::generic_category().message(errno)); }

void Descriptor::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(fd_, bytes.data(), bytes.size());
        if (written >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            fail();
        }
    }
}

void Descriptor::truncate(std::uint64_t size) noexcept {
    [[maybe_unused]] const int failed = ::ftruncate(fd_, static_cast<off_t>(size));
}

void Descriptor::sync() {
    if (::fsync(fd_) != 0) fail();
}

void Descriptor::sync_all() {
    if (::syncfs(fd_) != 0) fail();
}

void Descriptor::close() {
    if (::close(std::exchange(fd_, -1)) != 0) fail();
}

}  // namespace waterlight
