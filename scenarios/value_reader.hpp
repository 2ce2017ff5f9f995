// One TOML value into one setting.
#pragma once

#include <toml++/toml.h>
#include <optional>
#include <string>

#include "scenarios/schema.hpp"

namespace waterlight {

/// Sets the target. Returns what was found where that is not what the key allows; nothing if all is well. `raw` is what
/// was typed after --set KEY=, where the value comes from there: text is then taken literally.
std::optional<std::string> read_value(const Key& key, const Target& target, const toml::node& node,
                                      const std::string* raw);

/// A value in a few words: 3, "abc", a list of 3, a table.
std::string found_text(const toml::node& node);

}  // namespace waterlight
