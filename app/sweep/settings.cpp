#include "app/sweep/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "scenarios/origin.hpp"
#include "scenarios/reader.hpp"
#include "sim/error.hpp"
#include "sim/message.hpp"

namespace waterlight {

namespace {

constexpr std::size_t most_settings = 100000;

std::string trimmed(std::string text) {
    text.erase(0, text.find_first_not_of(" \t"));
    text.erase(text.find_last_not_of(" \t") + 1);
    return text;
}

std::vector<std::string> split_values(std::string_view text) {
    std::vector<std::string> values(1);
    int depth = 0;
    char quote = 0;
    for (const char c : text) {
        if (quote != 0) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '[' || c == '{') {
            ++depth;
        } else if (c == ']' || c == '}') {
            --depth;
        } else if (c == ',' && depth == 0) {
            values.emplace_back();
            continue;
        }
        values.back() += c;
    }
    for (std::string& value : values) value = trimmed(value);
    return values;
}

[[noreturn]] void reject_variation(const std::string& text, const std::string& key, const std::string& found) {
    reject("--vary " + text, key, found, "key=value,value,... with different values");
}

/// As if it had been a --set; the error names the --vary.
Scenario read(const SweepOptions& options, const std::vector<std::string>& overrides) {
    try {
        return read_scenario(options.scenario, overrides);
    } catch (const InputError& error) {
        const std::string says = error.what(), set = "--set ";
        for (std::size_t i = options.overrides.size(); i < overrides.size(); ++i)
            if (says.starts_with(set + shortened(overrides[i]))) throw InputError("--vary " + says.substr(set.size()));
        throw;
    }
}

/// Settings are judged by the truth.
void require_judged(const Scenario& s) {
    if (!s.objects.empty())
        s.origin.reject("object", "it in a sweep", "a scenario without: the truth that judges does not know objects");
    if (s.lamp) s.origin.reject("light.type", "a lamp in a sweep", "sun: the truth that judges does not know lamps");
}

Setting setting_at(const SweepOptions& options, const std::vector<Variation>& variations, std::size_t number) {
    Setting setting;
    setting.overrides = setting.scene = setting.waves = options.overrides;
    setting.values.resize(variations.size());
    for (std::size_t v = variations.size(); v-- > 0;) {
        const std::vector<std::string>& values = variations[v].values;
        setting.values[v] = values[number % values.size()];
        number /= values.size();
    }
    for (std::size_t v = 0; v < variations.size(); ++v) {
        const std::string& key = variations[v].key;
        const std::string override = key + "=" + setting.values[v];
        setting.overrides.push_back(override);
        if (is_method_of_light(key)) continue;
        setting.waves.push_back(override);
        if (!is_method_of_waves(key)) setting.scene.push_back(override);
    }
    setting.scenario = read(options, setting.overrides);
    require_judged(setting.scenario);
    return setting;
}

}  // namespace

Variation parse_variation(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || trimmed(text.substr(0, equals)).empty())
        reject_variation(text, "--vary", fmt::format("\"{}\"", text));
    Variation variation{trimmed(text.substr(0, equals)), split_values(std::string_view(text).substr(equals + 1))};
    std::set<std::string> seen;
    for (const std::string& value : variation.values) {
        if (value.empty()) reject_variation(text, variation.key, "no value");
        if (!seen.insert(value).second) reject_variation(text, variation.key, fmt::format("{} twice", value));
    }
    return variation;
}

bool is_method_of_waves(std::string_view key) {
    const std::string_view keys[] = {"domain.cells", "waves.model", "waves.cfl", "waves.margin_m", "output.every_s"};
    return std::find(std::begin(keys), std::end(keys), key) != std::end(keys);
}

bool is_method_of_light(std::string_view key) {
    const std::string_view places[] = {"caustics.floor.angle_deg", "caustics.floor.centre_m", "caustics.floor.size_m"};
    if (std::find(std::begin(places), std::end(places), key) != std::end(places)) return false;
    return key.starts_with("caustics.");
}

std::vector<Setting> settings_of(const SweepOptions& options, const std::vector<Variation>& variations) {
    std::set<std::string> keys;
    std::size_t count = 1;
    for (const Variation& variation : variations) {
        if (!keys.insert(variation.key).second) reject("--vary", variation.key, "it twice", "one --vary for a key");
        count *= variation.values.size();
        if (count > most_settings)
            reject("--vary", variation.key, fmt::format("more than {} settings", most_settings), "fewer values");
    }
    std::vector<Setting> settings;
    for (std::size_t n = 0; n < count; ++n) settings.push_back(setting_at(options, variations, n));
    return settings;
}

std::string text_of(const std::vector<Variation>& variations, const Setting& setting) {
    std::vector<std::string> words;
    for (std::size_t v = 0; v < variations.size(); ++v) words.push_back(variations[v].key + "=" + setting.values[v]);
    return words.empty() ? "the scenario as it is" : fmt::format("{}", fmt::join(words, " "));
}

}  // namespace waterlight
