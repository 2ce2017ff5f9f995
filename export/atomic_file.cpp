#include "export/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <system_error>

#include "export/descriptor.hpp"

namespace waterlight {

namespace fs = std::filesystem;

void throw_cannot_write(const fs::path& path, std::string_view reason) {
    throw WriteError(fmt::format("cannot write {}: {}", path.string(), reason));
}

PendingFile::PendingFile(fs::path path)
    : path_(std::move(path)), temporary_(path_.parent_path() / fmt::format(".{}.part", path_.filename().string())) {
    if (!path_.has_parent_path()) return;
    std::error_code error;
    fs::create_directories(path_.parent_path(), error);
    if (error) throw_cannot_write(path_, error.message());
}

PendingFile::~PendingFile() {
    std::error_code ignored;
    if (!committed_) fs::remove(temporary_, ignored);
}

void PendingFile::commit() {
    std::error_code error;
    fs::rename(temporary_, path_, error);
    if (error) throw_cannot_write(path_, error.message());
    committed_ = true;
}

void write_file(const fs::path& path, std::string_view bytes) {
    PendingFile pending(path);
    Descriptor file(pending.temporary(), path, O_WRONLY | O_CREAT | O_TRUNC);
    file.write(bytes);
    file.close();
    pending.commit();
}

}  // namespace waterlight
