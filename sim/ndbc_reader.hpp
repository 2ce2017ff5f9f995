// NDBC's real-time spectral wave files: https://www.ndbc.noaa.gov/measdes.shtml, "Raw Spectral Wave Data".
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace waterlight {

/// One record of the five files. All lists have one entry per frequency; NaN where a direction is missing (999).
struct NdbcRecord {
    std::string time;                  ///< "YYYY-MM-DD hh:mm", UTC
    std::vector<double> frequency_hz;  ///< rising
    std::vector<double> density;       ///< m^2/Hz, >= 0
    std::vector<double> alpha1_deg;    ///< mean direction from which waves come, clockwise from north
    std::vector<double> alpha2_deg;    ///< principal direction, likewise
    std::vector<double> r1, r2;        ///< first and second polar Fourier coefficients, [0, 1]
};

/// The record of `time`, or where that is empty the newest that all five files have with no density missing. Throws
/// InputError naming file and line where a file is absent, malformed or lacks the record, or where the frequencies of
/// two files differ.
NdbcRecord read_ndbc(const std::filesystem::path& stem, const std::string& time);

}  // namespace waterlight
