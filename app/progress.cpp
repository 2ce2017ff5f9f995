#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <string>

namespace waterlight {

namespace {

std::string duration_text(double seconds) {
    const int s = static_cast<int>(std::min(seconds + 0.5, 359999.0));
    if (s < 60) return fmt::format("{} s", s);
    if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
    return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
}

}  // namespace

Progress::Progress(std::FILE* stream, int total, bool quiet, std::string_view unit)
    : stream_(stream),
      total_(total),
      quiet_(quiet),
      unit_(unit),
      is_terminal_(isatty(fileno(stream)) != 0),
      start_(Clock::now()),
      last_(start_) {}

Progress::~Progress() { clear(); }

void Progress::clear() {
    if (is_drawn_) fmt::print(stream_, "\r\033[K");
    is_drawn_ = false;
    std::fflush(stream_);
}

void Progress::show(int done) {
    if (quiet_) return;
    const Clock::time_point now = Clock::now();
    const auto interval = is_terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(1000);
    if (now - last_ < interval && done < total_) return;
    last_ = now;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const double fraction = static_cast<double>(done) / total_;
    const std::string left = duration_text(elapsed * (total_ - done) / std::max(done, 1));
    if (!is_terminal_) {
        fmt::print(stream_, "{} {} of {} ({:.0f} %), {} left\n", unit_, done, total_, 100 * fraction, left);
    } else {
        constexpr int width = 40;
        const int filled = static_cast<int>(width * fraction);
        fmt::print(stream_, "\r\033[K[{:=<{}}{:<{}}] {:3.0f} %  {} {}/{}  {} left", "", filled, "", width - filled,
                   100 * fraction, unit_, done, total_, left);
        is_drawn_ = true;
    }
    std::fflush(stream_);
}

}  // namespace waterlight
