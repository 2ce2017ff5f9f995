// What is known of a setting once it has run, and the file that keeps it.
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace waterlight {

/// Errors are relative RMSE over the judged times; NaN where there is nothing to compare.
struct SettingErrors {
    double waves = std::numeric_limits<double>::quiet_NaN();  ///< of the elevation, against the reference waves
    double light = std::numeric_limits<double>::quiet_NaN();  ///< of the map, against the truth of the same surface
    double both = std::numeric_limits<double>::quiet_NaN();   ///< of the map, against the truth of the reference waves
    /// What a user sees: that of the map where there is one, else of the waves.
    double together() const { return both == both ? both : waves; }
};

/// Seconds of wall time of the whole run, without writing files.
struct SettingTimes {
    double waves = 0;
    double floor = 0;
    double total() const { return waves + floor; }
};

struct SettingResult {
    std::vector<std::string> overrides;
    SettingTimes wall_s;  ///< medians over the repeats
    SettingErrors errors;
    int frames = 0;
    std::string backend;
    std::string device;
    int threads = 0;
    std::string reference;  ///< what it was judged against, in words
    std::string failed;     ///< why it did not run; empty where it did
};

/// Whole or not at all. Throws WorldError.
void write_result(const std::filesystem::path& path, const SettingResult& result);
/// None where there is no such file. Throws WorldError where it is not ours.
std::optional<SettingResult> read_result(const std::filesystem::path& path);

}  // namespace waterlight
