// Text files of numbers, read block by block.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace waterlight {

/// A text file that is read forwards. Holds 64 KiB of it; lines end with LF or CRLF, and a byte order mark is skipped.
class TextFile {
  public:
    /// Throws InputError naming the file where it does not exist, cannot be opened or is no regular file.
    explicit TextFile(std::filesystem::path path);

    /// The next line without its end, or nothing after the last. The text stays until the next call. Throws InputError
    /// where a line is longer than 64 KiB, WorldError where the disk fails.
    std::optional<std::string_view> next_line();

    /// The next word between blanks and ends of lines, likewise.
    std::optional<std::string_view> next_word();

    /// Number of the line, from 1, of what was read last.
    long long line() const { return line_; }
    std::uintmax_t bytes() const { return bytes_; }
    const std::filesystem::path& path() const { return path_; }

    /// Throws InputError "PATH:LINE: what", of the line read last.
    [[noreturn]] void fail(const std::string& what) const;
    /// Throws InputError "PATH: what".
    [[noreturn]] void reject(const std::string& what) const;

  private:
    std::size_t left() const { return end_ - begin_; }
    bool refill();

    std::filesystem::path path_;
    std::uintmax_t bytes_ = 0;
    std::ifstream file_;
    std::vector<char> block_;
    std::size_t begin_ = 0, end_ = 0;  // of what is not read yet
    long long line_ = 0;
    long long ends_seen_ = 0;  // of lines, by next_word()
};

/// The number that `word` is, all of it; "nan" and "inf" are numbers here. Nothing for any other text, and for a number
/// that a double cannot hold.
std::optional<double> number_in(std::string_view word);

/// The first numbers of a line.
struct LineOfNumbers {
    std::array<double, 4> values{};
    int count = 0;  ///< of all numbers in the line, also of those beyond values
};

/// What a line says that holds numbers only, separated by blanks or by one comma each. Nothing for any other line.
std::optional<LineOfNumbers> numbers_in(std::string_view line);

/// ASCII letters made small.
std::string lower_case(std::string_view text);

/// Whether there is nothing but blanks in it.
bool is_blank(std::string_view line);

/// `text` in quotes as a message shows it: printable, and cut after 40 characters.
std::string quoted(std::string_view text);

}  // namespace waterlight
