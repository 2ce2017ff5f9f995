// Lines, words and numbers of the files of meshes.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "sim/error.hpp"

namespace waterlight {

[[noreturn]] inline void reject_mesh(const std::filesystem::path& file, std::string_view why) {
    throw InputError(fmt::format("{}: {}", file.string(), why));
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

/// The lines of a file, one after the other; complaints name the number of the last.
class MeshLines {
  public:
    MeshLines(const std::filesystem::path& file, std::string_view text) : file_(file), rest_(text) {}

    bool at_end() const { return rest_.empty(); }
    std::string_view rest() const { return rest_; }

    /// Without its end.
    std::string_view next() {
        const std::size_t end = rest_.find('\n');
        std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        ++number_;
        return line;
    }

    /// Three numbers off the front of a line.
    glm::dvec3 take_point(std::string_view& line) const {
        glm::dvec3 point;
        for (int k = 0; k < 3; ++k) {
            const std::optional<double> found = decimal_in(take_word(line));
            if (!found) reject("found no number; allowed: three");
            point[k] = *found;
        }
        return point;
    }

    [[noreturn]] void reject(std::string_view why) const {
        reject_mesh(file_, fmt::format("line {}: {}", number_, why));
    }
    void require(bool holds, std::string_view otherwise) const {
        if (!holds) reject(otherwise);
    }

  private:
    const std::filesystem::path& file_;
    std::string_view rest_;
    std::size_t number_ = 0;
};

}  // namespace waterlight
