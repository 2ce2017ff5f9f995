// TOML as it is read everywhere here.
#pragma once

#include <toml++/toml.h>

#include <string_view>

namespace waterlight {

/// Parts of a dotted key, more than any scenario's key has.
inline constexpr std::size_t most_key_parts = 32;

/// toml::parse(), which puts no bound on the parts of a dotted key and falls on 50 000 of them, a call deeper for
/// each (toml++ 3.3; tables and arrays within one another it bounds itself). Throws toml::parse_error also for more
/// than `most_key_parts`.
toml::table parse_toml(std::string_view text);

}  // namespace waterlight
