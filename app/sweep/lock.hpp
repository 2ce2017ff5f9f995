// One process at a time, across all that share a folder.
#pragma once

#include <filesystem>
#include <memory>

namespace waterlight {

/// An advisory lock by the name of a file, which it makes and removes. The system frees it when the process ends,
/// however it ends. Who waited for it must look whether what the lock is about has been made meanwhile.
class FileLock {
  public:
    /// Waits until it is free. Throws WorldError.
    explicit FileLock(std::filesystem::path path);
    /// None where another process has it. Throws WorldError.
    static std::unique_ptr<FileLock> try_for(std::filesystem::path path);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

  private:
    FileLock(std::filesystem::path path, int file) : path_(std::move(path)), file_(file) {}

    std::filesystem::path path_;
    int file_;
};

}  // namespace waterlight
