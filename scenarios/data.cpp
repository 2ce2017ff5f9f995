// Data files that a scenario names.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <span>
#include <utility>

#include "caustics/objects/mesh_file.hpp"
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

fs::path with(const fs::path& stem, std::string_view suffix) { return stem.string() + std::string(suffix); }

/// `suffix` is what the file's name has beyond the path.
fs::path locate(const Scenario& scenario, std::string_view key, const fs::path& relative, const std::string& suffix) {
    const auto with_suffix = [&](const fs::path& stem) { return with(stem, suffix); };
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

constexpr std::array<std::string_view, 1> no_suffix{""};
constexpr std::array<std::string_view, 5> buoy_suffixes{".data_spec", ".swdir", ".swdir2", ".swr1", ".swr2"};

/// Calls visit(key, path, suffixes) for the path of every data file, which it may change.
template <class Visit>
void visit_data(Scenario& scenario, Visit visit) {
    WavesSection& waves = scenario.waves;
    const auto of = [&](const std::string& key, std::optional<std::string>& path) {
        if (path) visit(key, *path, std::span<const std::string_view>(no_suffix));
    };
    of("domain.bathymetry", scenario.domain.bathymetry);
    of("waves.file", waves.file);
    for (std::size_t i = 0; i < waves.inflows.size(); ++i)
        of(fmt::format("waves.inflow[{}].file", i), waves.inflows[i].signal.file);
    for (std::size_t i = 0; i < scenario.checks.size(); ++i)
        if (scenario.checks[i].reference != "exact")
            of(fmt::format("check[{}].reference", i), scenario.checks[i].reference);
    for (std::size_t i = 0; i < scenario.objects.size(); ++i)
        of(fmt::format("object[{}].file", i), scenario.objects[i].file);
    if (!waves.buoy) return;
    std::string stem = waves.buoy->stem.string();
    visit("waves.buoy.stem", stem, std::span<const std::string_view>(buoy_suffixes));
    waves.buoy->stem = stem;
}

/// Whether both are found, and are the same file.
bool is_same_file(const Scenario& scenario, const std::string& key, const fs::path& stated, const fs::path& found,
                  std::string_view suffix) {
    try {
        return fs::equivalent(with(locate(scenario, key, stated, std::string(suffix)), suffix), with(found, suffix));
    } catch (const InputError&) {
        return false;
    }
}

/// As a TOML string.
std::string in_quotes(const std::string& text) {
    std::string quoted;
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return fmt::format("\"{}\"", quoted);
}

}  // namespace

std::vector<fs::path> data_files(const Scenario& scenario) {
    const WavesSection& waves = scenario.waves;
    std::vector<fs::path> files;
    if (scenario.domain.bathymetry) files.emplace_back(*scenario.domain.bathymetry);
    if (waves.file) files.emplace_back(*waves.file);
    for (const Inflow& inflow : waves.inflows)
        if (inflow.signal.file) files.emplace_back(*inflow.signal.file);
    for (const ObjectSection& section : scenario.objects)
        if (section.file) files.emplace_back(*section.file);
    if (waves.buoy)
        for (const std::string_view suffix : buoy_suffixes) files.push_back(with(waves.buoy->stem, suffix));
    return files;
}

void find_data(Scenario& scenario) {
    visit_data(scenario, [&](const std::string& key, std::string& path, std::span<const std::string_view> suffixes) {
        const fs::path stated = path;
        for (const std::string_view suffix : suffixes)
            path = locate(scenario, key, stated, std::string(suffix)).string();
    });
}

void read_data(Scenario& scenario) {
    if (scenario.objects.empty()) return;
    std::vector<Object> objects;
    for (std::size_t i = 0; i < scenario.objects.size(); ++i) {
        const ObjectSection& section = scenario.objects[i];
        Object object = section.object;
        const std::string key = fmt::format("object[{}]", i);
        try {
            if (section.file) object.shape = read_mesh(*section.file, section.file_scale, section.smooth);
            validate(object);
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}: {}: {}", scenario.origin.place(key + ".file"), key, error.what()));
        }
        objects.push_back(std::move(object));
    }
    scenario.object_set = std::make_shared<const ObjectSet>(std::move(objects));
}

std::vector<std::string> data_overrides(const Scenario& scenario, const fs::path& folder) {
    Scenario found = scenario;
    Scenario moved =
        parse_scenario(scenario.origin.text, fs::absolute(folder) / "scenario.toml", scenario.origin.overrides);
    std::vector<std::string> paths, overrides;
    visit_data(found, [&](const std::string&, const std::string& path, auto) { paths.push_back(path); });
    std::size_t n = 0;
    visit_data(moved, [&](const std::string& key, const std::string& stated, auto suffixes) {
        const std::string& path = paths[n++];
        const bool stays = std::ranges::all_of(
            suffixes, [&](std::string_view suffix) { return is_same_file(moved, key, stated, path, suffix); });
        if (!stays) overrides.push_back(fmt::format("{}={}", key, in_quotes(fs::absolute(path).string())));
    });
    return overrides;
}

}  // namespace waterlight
