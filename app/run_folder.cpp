#include "app/run_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <regex>
#include <string>
#include <system_error>
#include <vector>

#include "export/atomic_file.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

namespace fs = std::filesystem;

/// Names that only a run of ours gives to files that stay.
constexpr const char* our_names =
    "(surface|floor|volume|walls|camera)\\.pvd|(surface/surface|floor/floor|volume/volume|camera/camera|walls/"
    "(west|east|south|north))_[0-9]{6,}"
    "\\.vti|images/"
    "(elevation|irradiance|radiance|colour|scene|wall_(west|east|south|north))(16)?_[0-9]{6,}\\.(png|exr)|"
    "(probes|ledger|runup)\\.csv|extremes\\.vti|movie\\.mp4";
/// And to those that come and go.
constexpr const char* our_other_names = "report\\.json|checkpoint\\.bin";

/// Files of ours by their path within the folder.
template <class IsOurs>
std::vector<fs::path> files_of(const fs::path& folder, IsOurs is_ours) {
    std::vector<fs::path> found;
    for (const char* sub : {"", "surface", "floor", "volume", "walls", "camera", "images"}) {
        std::error_code ignored;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder / sub, ignored))
            if (is_ours(entry.path().lexically_relative(folder))) found.push_back(entry.path());
    }
    return found;
}

/// The path of the file that one in the making was to become; empty for any other.
fs::path finished_name(const fs::path& path) {
    static constexpr std::string_view suffix = ".part";
    const std::string name = path.filename().string();
    if (!name.starts_with('.') || !name.ends_with(suffix) || name.size() <= suffix.size() + 1) return {};
    return path.parent_path() / name.substr(1, name.size() - suffix.size() - 1);
}

std::string reason() { return std::generic_category().message(errno); }

/// What the run that holds the lock wrote into it.
std::string holder(int descriptor) {
    std::array<char, 32> text{};
    const ssize_t count = ::pread(descriptor, text.data(), text.size(), 0);
    return count > 0 ? fmt::format(" (process {})", std::string(text.data(), static_cast<std::size_t>(count))) : "";
}

}  // namespace

RunFolder::RunFolder(fs::path path) : path_(std::move(path)), lock_(path_ / ".waterlight.lock") {
    std::error_code error;
    fs::create_directories(path_, error);
    if (error) throw WorldError(fmt::format("cannot make the folder {}: {}", path_.string(), error.message()));
    take();
    remove_unfinished();
}

RunFolder::~RunFolder() {
    // While it is held: else another run could hold a lock that is then removed.
    if (is_held()) ::unlink(lock_.c_str());
    ::close(descriptor_);
}

void RunFolder::take() {
    for (;;) {
        descriptor_ = ::open(lock_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (descriptor_ < 0) throw_cannot_write(lock_, reason());
        if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
            const std::string why = errno == EWOULDBLOCK
                                        ? fmt::format("another run{} writes into it", holder(descriptor_))
                                        : fmt::format("it cannot be locked: {}", reason());
            ::close(descriptor_);
            throw WorldError(fmt::format("cannot write into {}: {}", path_.string(), why));
        }
        // The run that held it may have removed it in between.
        if (is_held()) break;
        ::close(descriptor_);
    }
    const std::string process = std::to_string(::getpid());
    [[maybe_unused]] const int cut = ::ftruncate(descriptor_, 0);
    [[maybe_unused]] const ssize_t written = ::pwrite(descriptor_, process.data(), process.size(), 0);
}

bool RunFolder::is_held() const {
    struct stat held = {}, there = {};
    // What cannot be reached may still be there: writing to it says why not.
    if (::stat(lock_.c_str(), &there) != 0) return errno != ENOENT && errno != ENOTDIR;
    return ::fstat(descriptor_, &held) == 0 && held.st_ino == there.st_ino && held.st_dev == there.st_dev;
}

void RunFolder::require_present() const {
    if (!is_held()) throw WorldError(fmt::format("the folder {} vanished while the run wrote into it", path_.string()));
}

void RunFolder::remove_unfinished() const {
    const std::regex ours(fmt::format("{}|{}", our_names, our_other_names));
    for (const fs::path& file : files_of(path_, [&](const fs::path& path) {
             return std::regex_match(finished_name(path).generic_string(), ours);
         })) {
        std::error_code ignored;
        fs::remove(file, ignored);
    }
}

void RunFolder::remove_stale(const std::set<fs::path>& written) const {
    const std::regex ours(our_names);
    for (const fs::path& file :
         files_of(path_, [&](const fs::path& path) { return std::regex_match(path.generic_string(), ours); }))
        if (std::error_code error; !written.contains(file) && !fs::remove(file, error) && error)
            throw WorldError(fmt::format("cannot remove {}: {}", file.string(), error.message()));
}

}  // namespace waterlight
