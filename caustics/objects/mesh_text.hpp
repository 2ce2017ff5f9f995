// Lines, words and numbers of the files of meshes.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "sim/error.hpp"

namespace waterlight {

[[noreturn]] inline void reject_mesh(const std::filesystem::path& file, const std::string& why) {
    throw InputError(fmt::format("{}: {}", file.string(), why));
}

/// Takes a line off the front; without its end.
inline std::string_view take_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
}

/// Takes a word off the front; empty where there is none.
inline std::string_view take_word(std::string_view& line) {
    constexpr std::string_view blanks = " \t\r\v\f";
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    line.remove_prefix(word.size());
    return word;
}

template <class Number>
std::optional<Number> number_in(std::string_view word) {
    Number n{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), n);
    return error == std::errc() && end == word.data() + word.size() ? std::optional(n) : std::nullopt;
}

/// As number_in(), and with a "+" too.
inline std::optional<double> decimal_in(std::string_view word) {
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    return number_in<double>(word);
}

inline bool is_printable(std::string_view text) {
    return std::ranges::all_of(text, [](unsigned char c) { return c >= 0x20 || c == '\n' || c == '\r' || c == '\t'; });
}

}  // namespace waterlight
