// key=value settings laid over a scenario's table before it is read.
#pragma once

#include <toml++/toml.h>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/origin.hpp"
#include "sim/message.hpp"

namespace waterlight {

/// One --set: where it goes and what it says.
struct Override {
    std::string text;  ///< "waves.source[0].at_m=[1.0, 2.0]"
    std::string key;   ///< before the first "="
    std::string raw;   ///< after it, as typed

    std::string place() const { return "--set " + shortened(text); }
    /// Whether `path` is this key or lies within it.
    bool covers(std::string_view path) const;
};

/// name or name[index]
struct KeyStep {
    std::string name;
    std::optional<std::size_t> index;
};

/// The steps of an override's key. Throws InputError where it is none.
std::vector<KeyStep> key_steps(const Override& override);
/// A table with what it states under "value". Throws InputError where that is none.
toml::table stated_value(const Override& override);

/// Throws InputError where there is no key or no "=".
Override parse_override(const std::string& text);

/// Lays an override over the table; sections on the way are made, and an index one past the end appends. A value that
/// is not TOML is taken as text, unless it starts like a list, a table or a quotation. Throws InputError.
void apply_override(toml::table& root, const Override& override);

}  // namespace waterlight
