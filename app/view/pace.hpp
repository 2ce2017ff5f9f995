// How fast a session goes: when its next frame is due, and what rate it keeps.
#pragma once

#include <chrono>
#include <deque>

namespace waterlight {

class Pace {
  public:
    using Clock = std::chrono::steady_clock;

    /// Wall time between frames, s.
    explicit Pace(double frame_s) : frame_(std::chrono::duration_cast<Clock::duration>(Seconds(frame_s))) {}

    double speed() const { return speed_; }
    void set_speed(double simulated_per_wall) {
        speed_ = simulated_per_wall;
        frames_.clear();
    }

    /// The next frame is due at once.
    void begin(Clock::time_point now) {
        due_ = now;
        frames_.clear();
    }
    Clock::time_point due() const { return due_; }
    /// A frame has been shown. What is late is not made up for.
    void shown(Clock::time_point now, double time_s) {
        due_ = (now > due_ + frame_ ? now : due_) + frame_;
        if (!frames_.empty() && time_s < frames_.back().time_s) frames_.clear();
        frames_.push_back({now, time_s});
        while (frames_.size() > 2 && now - frames_.front().wall > std::chrono::seconds(1)) frames_.pop_front();
    }
    /// Simulated seconds a second over the last second, or the last frame where that took longer; 0 before two frames.
    double rate() const {
        if (frames_.size() < 2) return 0;
        const Seconds wall = frames_.back().wall - frames_.front().wall;
        return (frames_.back().time_s - frames_.front().time_s) / wall.count();
    }

  private:
    using Seconds = std::chrono::duration<double>;
    struct Frame {
        Clock::time_point wall;
        double time_s;
    };
    Clock::duration frame_;
    double speed_ = 1;
    Clock::time_point due_{};
    std::deque<Frame> frames_;
};

}  // namespace waterlight
