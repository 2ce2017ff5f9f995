#include "scenarios/reader.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "scenarios/choose.hpp"
#include "scenarios/document.hpp"
#include "scenarios/memory.hpp"
#include "scenarios/resolve.hpp"
#include "scenarios/table_reader.hpp"
#include "scenarios/toml_text.hpp"

namespace waterlight {

namespace {

std::string read_text(const std::filesystem::path& file) {
    std::error_code ignored;
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file, ignored))
        reject(file.string(), "scenario", "no file that can be read", "the path of a scenario (.toml)");
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// What stands before "=" in a line, or the line itself: the nearest to a key that malformed TOML has.
std::string key_of_line(std::string_view text, std::size_t line) {
    for (std::size_t i = 1; i < line && !text.empty(); ++i) {
        const std::size_t end = text.find('\n');
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    std::string key(text.substr(0, std::min(text.find_first_of("=\n"), text.size())));
    key.erase(0, key.find_first_not_of(" \t\r"));
    key.erase(key.find_last_not_of(" \t\r") + 1);
    return key.empty() || key.size() > 60 ? "TOML" : key;
}

toml::table parse_file(std::string_view text, const std::filesystem::path& file) {
    try {
        return parse_toml(text);
    } catch (const toml::parse_error& error) {
        const toml::source_position at = error.source().begin;
        reject(fmt::format("{}:{}:{}", file.string(), at.line, at.column), key_of_line(text, at.line),
               fmt::format("malformed TOML ({})", error.description()), "TOML 1.0");
    }
}

/// A solitary wave starts on the depth of the domain where it states none.
void fill_depths(Scenario& scenario) {
    std::vector<ShallowInitial>& initial = scenario.waves.initial;
    for (std::size_t i = 0; i < initial.size(); ++i) {
        auto* wave = std::get_if<SolitaryWave>(&initial[i]);
        if (wave && !scenario.origin.places.contains(fmt::format("waves.initial[{}].depth_m", i)))
            wave->depth_m = scenario.domain.depth_m;
    }
}

/// Where the model is open, with one that can carry all keys, or that which its keys hint at.
Scenario possible(const Scenario& scenario) {
    if (scenario.waves.model != ModelChoice::automatic) return scenario;
    Scenario tried = scenario;
    using enum ModelChoice;
    for (const ModelChoice model : {resolve_model(scenario).model, airy, shallow_water, linear}) {
        tried.waves.model = model;
        try {
            check_combinations(tried);
            return tried;
        } catch (const InputError&) {
            continue;
        }
    }
    return scenario;
}

Scenario open_scenario(std::string_view text, const std::filesystem::path& file,
                       const std::vector<std::string>& overrides) {
    Scenario scenario = parse_scenario(text, file, overrides);
    check_combinations(possible(scenario));
    if (!is_open(scenario)) check_memory(scenario, machine_memory());
    find_data(scenario);
    read_data(scenario);
    return scenario;
}

Scenario settled(Scenario scenario) {
    if (!is_open(scenario)) {
        warn_of_breaking(scenario);
        return scenario;
    }
    settle(scenario, choose(scenario));
    check_combinations(scenario);
    check_memory(scenario, machine_memory());
    return scenario;
}

}  // namespace

Scenario parse_scenario(std::string_view text, const std::filesystem::path& file,
                        const std::vector<std::string>& overrides) {
    Scenario scenario;
    scenario.origin.file = file;
    scenario.origin.text = text;
    scenario.origin.overrides = overrides;
    toml::table root = parse_file(text, file);
    std::vector<Override> parsed;
    for (const std::string& override : overrides) {
        parsed.push_back(parse_override(override));
        apply_override(root, parsed.back());
    }
    const std::vector<std::string> known = known_keys();
    ReadContext context{scenario.origin, parsed, known};
    TableReader reader(context, &root, "");
    describe(reader, scenario);
    reader.finish();
    scenario.water.depth_m = scenario.domain.depth_m;
    fill_depths(scenario);
    return scenario;
}

Scenario read_open_scenario(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
    return open_scenario(read_text(file), file, overrides);
}

Scenario read_scenario(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
    return settled(read_open_scenario(file, overrides));
}

Scenario read_again(const Origin& origin, const std::vector<std::string>& overrides) {
    return settled(open_scenario(origin.text, origin.file, overrides));
}

}  // namespace waterlight
