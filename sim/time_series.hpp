// A number that changes in time, as a gauge or a wavemaker records it.
#pragma once

#include <filesystem>
#include <vector>

namespace waterlight {

/// Values at times that increase strictly.
struct TimeSeries {
    std::vector<double> time_s;
    std::vector<double> value;  ///< as many as times, at least one

    bool empty() const { return time_s.empty(); }
    /// Linear between the times; the first value before them, the last one after them.
    double at(double time_s) const;
    /// The slope of at(); zero outside the times. At a time of the series, that of the interval that begins there.
    double rate_at(double time_s) const;
    double end_s() const { return time_s.back(); }
};

/// One value at all times.
TimeSeries constant_series(double value);

/// Reads two columns, time (s) and value, separated by blanks or a comma; lines before the first pair of numbers are a
/// heading, lines that begin with # are comments. `scale` multiplies the values. Throws InputError that names the file
/// and the line: no file, no numbers, a line that is not two numbers, a number that is not finite, times that do not
/// increase.
TimeSeries read_time_series(const std::filesystem::path& path, double scale = 1);

}  // namespace waterlight
