// How far a run is: a bar with the time left on a terminal, one line a second elsewhere.
#pragma once

#include <chrono>
#include <cstdio>
#include <string_view>

namespace waterlight {

class Progress {
  public:
    /// Writes to `stream` unless quiet. total > 0 frames, or what `unit` calls them (a literal).
    Progress(std::FILE* stream, int total, bool quiet, std::string_view unit = "frame");
    /// Clears the bar.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Call after each frame; shows something at most ten times a second on a terminal, once a second elsewhere, and
    /// for the last frame.
    void show(int done);

  private:
    using Clock = std::chrono::steady_clock;
    void clear();

    std::FILE* stream_;
    int total_;
    bool quiet_;
    std::string_view unit_;
    bool is_terminal_;
    bool is_drawn_ = false;
    Clock::time_point start_;
    Clock::time_point last_;
};

}  // namespace waterlight
