#include "scenarios/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "scenarios/toml_text.hpp"

namespace waterlight {

namespace {

constexpr std::string_view key_form = "key=value, with a key such as domain.cells or waves.source[0].at_m";

bool is_bare(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

[[noreturn]] void reject_key(const Override& o) {
    reject(o.place(), o.key.empty() ? "--set" : o.key, fmt::format("the key \"{}\"", o.key), key_form);
}

KeyStep parse_step(std::string_view part, const Override& o) {
    KeyStep step;
    const std::size_t bracket = part.find('[');
    step.name = part.substr(0, bracket);
    if (step.name.empty() || !std::all_of(step.name.begin(), step.name.end(), is_bare)) reject_key(o);
    if (bracket == std::string_view::npos) return step;
    const char* end = part.data() + part.size() - 1;
    std::size_t index = 0;
    const auto [stop, error] = std::from_chars(part.data() + bracket + 1, end, index);
    if (part.back() != ']' || error != std::errc() || stop != end) reject_key(o);
    step.index = index;
    return step;
}

/// The table that one step leads to, made where it is missing.
toml::table& descend(toml::table& from, const KeyStep& step, const Override& o) {
    if (!step.index) {
        toml::node& node = from.insert(step.name, toml::table{}).first->second;
        if (!node.is_table()) reject(o.place(), o.key, fmt::format("\"{}\", which is no section", step.name), key_form);
        return *node.as_table();
    }
    toml::array* list = from.insert(step.name, toml::array{}).first->second.as_array();
    if (!list) reject(o.place(), o.key, fmt::format("\"{}\", which is no list", step.name), key_form);
    if (*step.index > list->size())
        reject(o.place(), o.key, fmt::format("index {}", *step.index), fmt::format("0 to {}", list->size()));
    if (*step.index == list->size()) list->push_back(toml::table{});
    toml::table* element = list->get(*step.index)->as_table();
    if (!element) reject(o.place(), o.key, fmt::format("\"{}\", whose elements are no sections", step.name), key_form);
    return *element;
}

}  // namespace

std::vector<KeyStep> key_steps(const Override& o) {
    std::vector<KeyStep> steps;
    std::string_view rest = o.key;
    while (true) {
        const std::size_t dot = rest.find('.');
        steps.push_back(parse_step(rest.substr(0, dot), o));
        if (steps.size() > most_key_parts) reject_key(o);
        if (dot == std::string_view::npos) return steps;
        rest.remove_prefix(dot + 1);
    }
}

toml::table stated_value(const Override& o) {
    try {
        toml::table parsed = parse_toml("value = " + o.raw);
        if (parsed.size() == 1) return parsed;
    } catch (const toml::parse_error&) {
        if (!o.raw.empty() && std::string_view("[{\"'").find(o.raw.front()) == std::string_view::npos)
            return toml::table{{"value", o.raw}};
    }
    reject(o.place(), o.key, fmt::format("\"{}\"", o.raw), "one TOML value");
}

bool Override::covers(std::string_view path) const {
    if (path.substr(0, key.size()) != key) return false;
    return path.size() == key.size() || path[key.size()] == '.' || path[key.size()] == '[';
}

Override parse_override(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        reject("--set " + shortened(text), "--set", fmt::format("\"{}\"", text), key_form);
    const auto trimmed = [](std::string s) {
        s.erase(0, s.find_first_not_of(" \t"));
        s.erase(s.find_last_not_of(" \t") + 1);
        return s;
    };
    return {text, trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1))};
}

void apply_override(toml::table& root, const Override& o) {
    std::vector<KeyStep> steps = key_steps(o);
    const KeyStep last = steps.back();
    steps.pop_back();
    toml::table* table = &root;
    for (const KeyStep& step : steps) table = &descend(*table, step, o);
    toml::table parsed = stated_value(o);
    toml::node& value = *parsed.get("value");
    if (!last.index) {
        table->insert_or_assign(last.name, value);
        return;
    }
    const toml::table* whole = value.as_table();
    if (!whole) reject(o.place(), o.key, fmt::format("\"{}\"", o.raw), "a table {...} for an element of a list");
    descend(*table, last, o) = *whole;
}

}  // namespace waterlight
