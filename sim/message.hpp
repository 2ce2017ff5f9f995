// What a message repeats of a file, which may hold anything of any length, so that it stays a line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace waterlight {

/// The text with blanks for control characters, which would break the line or the terminal.
inline std::string in_one_line(std::string_view text) {
    std::string line(text);
    for (char& c : line)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
    return line;
}

/// The text, or its beginning and "...", cut between characters of UTF-8.
inline std::string shortened(std::string_view text, std::size_t most_bytes = 300) {
    if (text.size() <= most_bytes) return std::string(text);
    std::size_t end = most_bytes;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // not within a character
    return std::string(text.substr(0, end)) + "...";
}

}  // namespace waterlight
