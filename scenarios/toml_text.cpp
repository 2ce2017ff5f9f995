#include "scenarios/toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace waterlight {

namespace {

/// Behind the string that begins with a quote at `begin`; at the end of its line where it has no end there.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
    const char quote = text[begin];
    const std::string three(3, quote);
    const bool is_long = text.substr(begin).starts_with(three);
    std::size_t at = begin + (is_long ? 3 : 1);
    while (at < text.size()) {
        const bool is_escape = quote == '"' && text[at] == '\\';
        if (is_escape) {
            at += 2;
        } else if (is_long && text.substr(at).starts_with(three)) {
            // Up to two quotes more belong to the string.
            return std::min(text.find_first_not_of(quote, at), text.size());
        } else if (!is_long && (text[at] == quote || text[at] == '\n')) {
            return at + 1;
        } else {
            ++at;
        }
    }
    return text.size();
}

/// Where a key gets its first part too many; npos: nowhere. Of malformed text, what stands before its first fault
/// counts.
std::size_t part_too_many(std::string_view text) {
    std::size_t parts = 1;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '"' || c == '\'') {
            at = end_of_string(text, at);
        } else if (c == '#') {
            at = std::min(text.find('\n', at), text.size());
        } else {
            if (c == '.' && ++parts > most_key_parts) return at;
            if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) parts = 1;
            ++at;
        }
    }
    return std::string_view::npos;
}

}  // namespace

toml::table parse_toml(std::string_view text) {
    if (const std::size_t at = part_too_many(text); at != std::string_view::npos) {
        const std::string_view before = text.substr(0, at);
        const auto lines = static_cast<toml::source_index>(std::ranges::count(before, '\n'));
        const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 = 0
        const std::string why = fmt::format("a key of more than {} parts", most_key_parts);
        throw toml::parse_error(why.c_str(),
                                toml::source_position{lines + 1, static_cast<toml::source_index>(at - line_begin + 1)});
    }
    return toml::parse(text);
}

}  // namespace waterlight
