#include "app/moments.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/check_watch.hpp"

namespace waterlight {

namespace {

constexpr double interval_slack = 1e-9;  // of an interval: a duration that is a multiple but for rounding

/// Times from the start: `every` apart, the last at the end.
std::vector<double> times_of(double every, double duration) {
    const int whole = static_cast<int>(std::floor(duration / every + interval_slack));
    std::vector<double> times;
    for (int i = 0; i <= whole; ++i) times.push_back(i * every);
    if (duration - whole * every > interval_slack * every) times.push_back(duration);
    return times;
}

}  // namespace

std::vector<Moment> moments_of(const Scenario& s) {
    const double duration = s.waves.duration_s, every = s.output.probe_every_s.value_or(s.output.every_s);
    std::vector<double> times = times_of(s.output.every_s, duration);
    for (const double checked : checked_times(s)) {
        const double room = interval_slack * s.output.every_s;
        const auto next = std::lower_bound(times.begin(), times.end(), checked - room);
        const bool is_there = next != times.end() && *next <= checked + room;
        if (!is_there) times.insert(next, checked);
    }
    std::vector<Moment> moments;
    for (const double time : times) moments.push_back({time, true});
    if (!s.output.probe_every_s || s.probes.empty()) return moments;
    std::vector<Moment> rows;
    std::size_t frame = 0;
    for (const double time : times_of(every, duration)) {
        while (frame < moments.size() && moments[frame].time_s < time - interval_slack * every) ++frame;
        const bool coincides = frame < moments.size() && moments[frame].time_s <= time + interval_slack * every;
        if (!coincides) rows.push_back({time, false});
    }
    std::vector<Moment> all;
    std::merge(rows.begin(), rows.end(), moments.begin(), moments.end(), std::back_inserter(all),
               [](const Moment& a, const Moment& b) { return a.time_s < b.time_s; });
    return all;
}

std::vector<int> regular_frames(const std::vector<Moment>& moments, double every_s) {
    std::vector<int> regular;
    int frame = 0;
    for (const Moment& moment : moments) {
        if (!moment.is_frame) continue;
        const double intervals = moment.time_s / every_s;
        constexpr double rounding = 1e-6;
        if (std::abs(intervals - std::round(intervals)) < rounding) regular.push_back(frame);
        ++frame;
    }
    return regular;
}

}  // namespace waterlight
