// Data files that a scenario names.
#include <fmt/format.h>

#include <array>
#include <cstdlib>

#include "scenarios/reader.hpp"

namespace waterlight {

namespace {

namespace fs = std::filesystem;

bool readable(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

/// A file in a folder that is neither beside the scenario nor below $WATERLIGHT_DATA is data that this machine lacks;
/// any other is a wrong path.
bool is_lacking(const fs::path& beside, const char* data, const fs::path& relative) {
    std::error_code ignored;
    const bool has_folder = relative.is_relative() && relative.has_parent_path() && *relative.begin() != "..";
    const bool is_here = fs::exists(beside.parent_path(), ignored);
    return has_folder && !is_here && !(data && fs::exists(fs::path(data) / *relative.begin(), ignored));
}

/// `suffix` is what the file's name has beyond the path.
fs::path locate(const Scenario& scenario, std::string_view key, const fs::path& relative, const std::string& suffix) {
    const auto with_suffix = [&](const fs::path& stem) { return fs::path(stem.string() + suffix); };
    const fs::path beside = scenario.origin.file.parent_path() / relative;
    if (readable(with_suffix(beside))) return beside;
    const char* data = std::getenv("WATERLIGHT_DATA");
    if (data && readable(with_suffix(fs::path(data) / relative))) return fs::path(data) / relative;
    const std::string below =
        data ? fmt::format("\"{}\"", with_suffix(fs::path(data) / relative).string())
             : fmt::format("\"{}\" below $WATERLIGHT_DATA, which is not set", relative.string() + suffix);
    try {
        scenario.origin.reject(key, fmt::format("no file \"{}\" nor {}", with_suffix(beside).string(), below),
                               "a path that exists beside the scenario or below $WATERLIGHT_DATA");
    } catch (const InputError& error) {
        if (is_lacking(beside, data, relative)) throw MissingData(error.what());
        throw;
    }
}

constexpr std::array buoy_suffixes{".data_spec", ".swdir", ".swdir2", ".swr1", ".swr2"};

}  // namespace

std::vector<fs::path> data_files(const Scenario& scenario) {
    const WavesSection& waves = scenario.waves;
    std::vector<fs::path> files;
    if (scenario.domain.bathymetry) files.emplace_back(*scenario.domain.bathymetry);
    if (waves.file) files.emplace_back(*waves.file);
    for (const Inflow& inflow : waves.inflows)
        if (inflow.signal.file) files.emplace_back(*inflow.signal.file);
    if (waves.buoy)
        for (const char* suffix : buoy_suffixes) files.emplace_back(waves.buoy->stem.string() + suffix);
    return files;
}

void find_data(Scenario& scenario) {
    WavesSection& waves = scenario.waves;
    std::optional<std::string>& ground = scenario.domain.bathymetry;
    if (ground) ground = locate(scenario, "domain.bathymetry", *ground, "").string();
    if (waves.file) waves.file = locate(scenario, "waves.file", *waves.file, "").string();
    for (std::size_t i = 0; i < waves.inflows.size(); ++i)
        if (std::optional<std::string>& file = waves.inflows[i].signal.file)
            file = locate(scenario, fmt::format("waves.inflow[{}].file", i), *file, "").string();
    for (std::size_t i = 0; i < scenario.checks.size(); ++i)
        if (std::optional<std::string>& file = scenario.checks[i].reference; file && *file != "exact")
            file = locate(scenario, fmt::format("check[{}].reference", i), *file, "").string();
    if (!waves.buoy) return;
    const fs::path stem = waves.buoy->stem;
    for (const char* suffix : buoy_suffixes) waves.buoy->stem = locate(scenario, "waves.buoy.stem", stem, suffix);
}

}  // namespace waterlight
