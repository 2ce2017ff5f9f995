#include "scenarios/origin.hpp"

#include <fmt/format.h>

namespace waterlight {

namespace {

/// Control characters would break the line or the terminal.
std::string in_one_line(std::string_view text) {
    std::string line;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        line += byte < 0x20 || byte == 0x7f ? ' ' : c;
    }
    return line;
}

}  // namespace

std::string shortened(std::string_view text, std::size_t most_bytes) {
    if (text.size() <= most_bytes) return std::string(text);
    std::size_t end = most_bytes;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // not within a character
    return fmt::format("{}...", text.substr(0, end));
}

void reject(std::string_view place, std::string_view key, std::string_view found, std::string_view allowed,
            std::string_view nearest) {
    std::string message =
        fmt::format("{}: {}: found {}; allowed: {}", place, shortened(key), shortened(found), allowed);
    if (!nearest.empty()) message += fmt::format("; did you mean \"{}\"?", nearest);
    throw InputError(in_one_line(message));
}

std::string Origin::place(std::string_view key) const {
    while (!key.empty()) {
        if (const auto stated = places.find(key); stated != places.end()) return stated->second;
        const std::size_t end = key.find_last_of(".[");
        key = key.substr(0, end == std::string_view::npos ? 0 : end);
    }
    return file.string();
}

void Origin::reject(std::string_view key, std::string_view found, std::string_view allowed) const {
    waterlight::reject(place(key), key, found, allowed);
}

void Origin::reject(std::string_view key, const InputError& what) const {
    throw InputError(fmt::format("{}: {}: {}", place(key), key, what.what()));
}

}  // namespace waterlight
