// A file descriptor that closes itself and throws the system's reason.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace waterlight {

class Descriptor {
  public:
    /// Opens `file` with open(2)'s flags, mode 0666. Errors, here and below, throw WorldError naming `reported_as`.
    Descriptor(const std::filesystem::path& file, std::filesystem::path reported_as, int flags);
    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    /// Writes all of `bytes`, in a single system call where the system lets it be one.
    void write(std::string_view bytes);
    /// Cuts the file to `size` bytes; never throws.
    void truncate(std::uint64_t size) noexcept;
    /// Returns once the file, or the folder's list of names, is on the disk.
    void sync();
    /// Returns once all that was written to its file system is on the disk.
    void sync_all();
    /// Closes, and throws what the system only says then.
    void close();

  private:
    [[noreturn]] void fail() const;

    std::filesystem::path reported_as_;
    int fd_;
};

}  // namespace waterlight
