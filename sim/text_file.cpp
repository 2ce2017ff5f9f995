#include "sim/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>

#include "sim/error.hpp"

namespace waterlight {

namespace {

constexpr std::size_t block_bytes = 65536;
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

std::string_view without_blanks_before(std::string_view text) {
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    return text;
}

std::string_view first_word(std::string_view text) {
    const auto ends = [](char c) { return is_space(c) || c == ','; };
    return text.substr(0, static_cast<std::size_t>(std::ranges::find_if(text, ends) - text.begin()));
}

}  // namespace

TextFile::TextFile(std::filesystem::path path) : path_(std::move(path)), block_(block_bytes) {
    std::error_code error;
    const auto status = std::filesystem::status(path_, error);
    if (!std::filesystem::exists(status)) reject("cannot be read: No such file");
    if (!std::filesystem::is_regular_file(status)) reject("is no file of text");
    bytes_ = std::filesystem::file_size(path_, error);
    file_.open(path_, std::ios::binary);
    if (error || !file_) reject("cannot be opened for reading");
    refill();
    if (std::string_view(block_.data(), end_).starts_with(byte_order_mark)) begin_ = byte_order_mark.size();
}

void TextFile::fail(const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", path_.string(), line_, what));
}

void TextFile::reject(const std::string& what) const { throw InputError(fmt::format("{}: {}", path_.string(), what)); }

/// Brings more of the file behind what is left of the block; false at the end of the file.
bool TextFile::refill() {
    std::memmove(block_.data(), block_.data() + begin_, left());
    end_ = left();
    begin_ = 0;
    if (!file_) return false;
    file_.read(block_.data() + end_, static_cast<std::streamsize>(block_.size() - end_));
    if (file_.bad()) throw WorldError(fmt::format("{}: the disk failed while it was read", path_.string()));
    end_ += static_cast<std::size_t>(file_.gcount());
    return file_.gcount() > 0;
}

std::optional<std::string_view> TextFile::next_line() {
    const void* found = nullptr;
    while ((found = std::memchr(block_.data() + begin_, '\n', left())) == nullptr) {
        if (left() == block_.size()) {
            ++line_;
            fail(fmt::format("is longer than {} characters; a line of a few numbers is wanted", block_.size()));
        }
        if (!refill()) break;
    }
    if (found == nullptr && left() == 0) return {};
    ++line_;
    const char* const start = block_.data() + begin_;
    const auto length = found != nullptr ? static_cast<std::size_t>(static_cast<const char*>(found) - start) : left();
    begin_ += length + (found != nullptr ? 1 : 0);
    std::string_view line(start, length);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

std::optional<std::string_view> TextFile::next_word() {
    do {
        for (; begin_ < end_ && is_space(block_[begin_]); ++begin_) ends_seen_ += block_[begin_] == '\n' ? 1 : 0;
    } while (begin_ == end_ && refill());
    line_ = ends_seen_ + 1;
    std::size_t length = 0;
    while (true) {
        while (length < left() && !is_space(block_[begin_ + length])) ++length;
        if (length < left()) break;
        if (length == block_.size()) fail(fmt::format("holds a word of more than {} characters", length));
        if (!refill()) break;
    }
    if (length == 0) return {};
    const std::string_view word(block_.data() + begin_, length);
    begin_ += length;
    return word;
}

std::optional<double> number_in(std::string_view word) {
    // std::from_chars knows no plus sign.
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
    double number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size()) return {};
    return number;
}

std::optional<LineOfNumbers> numbers_in(std::string_view line) {
    LineOfNumbers numbers;
    std::string_view rest = without_blanks_before(line);
    while (!rest.empty()) {
        const std::string_view word = first_word(rest);
        const std::optional<double> number = number_in(word);
        if (!number) return {};
        if (numbers.count < static_cast<int>(numbers.values.size())) {
            numbers.values[static_cast<std::size_t>(numbers.count)] = *number;
        }
        ++numbers.count;
        rest = without_blanks_before(rest.substr(word.size()));
        if (!rest.starts_with(',')) continue;
        rest = without_blanks_before(rest.substr(1));
        if (rest.empty()) return {};
    }
    if (numbers.count == 0) return {};
    return numbers;
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

bool is_blank(std::string_view line) { return without_blanks_before(line).empty(); }

std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 40;
    std::string shown(text.substr(0, longest));
    std::ranges::replace_if(
        shown, [](char c) { return c < ' ' || c > '~'; }, '?');
    return fmt::format("\"{}{}\"", shown, text.size() > longest ? "..." : "");
}

}  // namespace waterlight
