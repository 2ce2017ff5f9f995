#include "app/movie.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/bytes_of.hpp"
#include "app/fed_process.hpp"
#include "export/atomic_file.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

namespace fs = std::filesystem;

fs::path ffmpeg() {
    const std::optional<fs::path> program = find_program("ffmpeg");
    if (!program) throw WorldError("--movie: there is no ffmpeg in $PATH (Debian's package is ffmpeg)");
    return *program;
}

std::string picture_in(const fs::path& file) {
    std::string bytes = bytes_of(file);
    if (bytes.empty()) throw WorldError(fmt::format("cannot read {} for the movie", file.string()));
    return bytes;
}

/// PNG files one after another in, a movie out.
std::vector<std::string> arguments_for(const fs::path& to, double frames_per_s) {
    std::vector<std::string> words{"-hide_banner", "-loglevel", "error", "-y", "-f", "image2pipe", "-c:v", "png"};
    const auto add = [&](std::initializer_list<std::string> more) { words.insert(words.end(), more); };
    add({"-framerate", fmt::format("{:.6f}", frames_per_s), "-i", "pipe:0"});
    add({"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv"});
    add({"-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p", "-colorspace", "bt709", "-color_primaries", "bt709"});
    add({"-color_trc", "iec61966-2-1", "-color_range", "tv", "-movflags", "+faststart"});
    // Given as a URL, so that no name is taken for an option or a protocol.
    add({"-f", "mp4", "file:" + to.string()});
    return words;
}

[[noreturn]] void throw_failed(const fs::path& file, std::string said) {
    std::ranges::replace(said, '\n', ' ');
    throw_cannot_write(file, said.empty() ? "ffmpeg failed" : "ffmpeg: " + said);
}

}  // namespace

void require_ffmpeg() { ffmpeg(); }

void write_movie(const fs::path& file, std::span<const fs::path> pictures, double frames_per_s) {
    PendingFile pending(file);
    FedProcess process(ffmpeg(), arguments_for(pending.temporary(), frames_per_s));
    for (const fs::path& picture : pictures)
        if (!process.write(picture_in(picture))) break;
    if (!process.finish()) throw_failed(file, process.said());
    pending.commit();
}

}  // namespace waterlight
