// Files that appear under their name only when they are whole.
#pragma once

#include <filesystem>
#include <string_view>

#include "sim/error.hpp"

namespace waterlight {

/// A file cannot be written: not the fault of what is computed.
struct WriteError : WorldError {
    using WorldError::WorldError;
};

/// A file in the making. It is written under temporary(), a hidden name in the folder of `path`, and takes its own name
/// in commit(). Without commit() the destructor removes it. A process that is killed leaves at most the hidden file,
/// which the next attempt at the same `path` overwrites. One writer per `path` at a time.
class PendingFile {
  public:
    /// Makes the folder where it is missing. Throws WriteError where it cannot be made.
    explicit PendingFile(std::filesystem::path path);
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    const std::filesystem::path& temporary() const { return temporary_; }
    /// Renames temporary() to `path`, replacing what is there. Throws WriteError.
    void commit();

  private:
    std::filesystem::path path_;
    std::filesystem::path temporary_;
    bool committed_ = false;
};

/// Writes `bytes` as the whole content of `path`, or throws WriteError naming the path and the system's reason, and
/// then leaves what was at `path` as it was.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Throws WriteError "cannot write PATH: REASON".
[[noreturn]] void throw_cannot_write(const std::filesystem::path& path, std::string_view reason);

}  // namespace waterlight
