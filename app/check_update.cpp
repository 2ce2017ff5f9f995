#include "app/check_update.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "app/bytes_of.hpp"
#include "export/atomic_file.hpp"
#include "scenarios/reader.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

/// Where a line starts, from 1.
std::size_t start_of_line(std::string_view text, int line) {
    std::size_t at = 0;
    for (int n = 1; n < line && at != std::string_view::npos; ++n) {
        at = text.find('\n', at);
        if (at != std::string_view::npos) ++at;
    }
    return at;
}

/// FILE:LINE:COL of a value in the file itself; none where an override states it.
std::optional<glm::ivec2> line_and_column(const Scenario& scenario, const std::string& key) {
    const auto stated = scenario.origin.places.find(key);
    const std::string prefix = scenario.origin.file.string() + ":";
    if (stated == scenario.origin.places.end() || !stated->second.starts_with(prefix)) return std::nullopt;
    glm::ivec2 at;
    const char* const end = stated->second.data() + stated->second.size();
    const auto line = std::from_chars(stated->second.data() + prefix.size(), end, at.x);
    if (line.ec != std::errc() || line.ptr == end) return std::nullopt;
    const auto column = std::from_chars(line.ptr + 1, end, at.y);
    return column.ec == std::errc() ? std::optional(at) : std::nullopt;
}

/// Length of the number of TOML that the text starts with.
std::size_t number_length(std::string_view text) {
    return std::min(text.find_first_not_of("0123456789+-._eE"), text.size());
}

bool is_number(std::string text, double value) {
    std::erase_if(text, [](char c) { return c == '_' || c == '+'; });
    double read = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), read);
    return error == std::errc() && end == text.data() + text.size() && read == value;
}

std::string new_number(double value, double tolerance) {
    const double error = 0.01 * tolerance;
    const int digits = std::clamp(static_cast<int>(std::ceil(std::log10(std::abs(value) / error))) + 1, 3, 17);
    std::string text = value == 0 || std::abs(value) < error ? "0.0" : fmt::format("{:.{}g}", value, digits);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

std::string line_around(std::string_view text, std::size_t at) {
    const std::size_t before = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    return std::string(text.substr(begin, std::min(text.find('\n', at), text.size()) - begin));
}

}  // namespace

std::vector<CheckUpdate> updates_of(const CheckItem& item, const ItemOutcome& outcome) {
    std::vector<CheckUpdate> updates;
    for (std::size_t n = 0; n < outcome.checks.size(); ++n) {
        const CheckOutcome& found = outcome.checks[n];
        const Check& check = item.scenario->checks[static_cast<std::size_t>(found.check)];
        const bool is_equals = check.equals && found.expected.starts_with("= ");
        if (!is_equals || found.verdict != Verdict::failed || !std::isfinite(found.value)) continue;
        const auto at = line_and_column(*item.scenario, fmt::format("check[{}].equals", found.check));
        if (!at) continue;
        const std::string& text = item.scenario->origin.text;
        const std::size_t begin = start_of_line(text, at->x) + static_cast<std::size_t>(at->y - 1);
        if (begin >= text.size()) continue;
        const std::size_t length = number_length(std::string_view(text).substr(begin));
        const std::string old_text = text.substr(begin, length);
        if (!is_number(old_text, *check.equals)) continue;
        const double tolerance = std::max(check.tolerance, check.relative_tolerance * std::abs(found.value));
        updates.push_back({n, begin, length, old_text, new_number(found.value, tolerance), at->x});
    }
    std::sort(updates.begin(), updates.end(), [](const auto& a, const auto& b) { return a.begin < b.begin; });
    return updates;
}

std::string diff_text(const CheckItem& item, const std::vector<CheckUpdate>& updates) {
    const std::string file = item.file.string(), &text = item.scenario->origin.text;
    std::string diff = fmt::format("--- {}\n+++ {}\n", file, file);
    for (const CheckUpdate& update : updates) {
        const std::string line = line_around(text, update.begin);
        std::string changed = line;
        changed.replace(update.begin - start_of_line(text, update.line), update.length, update.new_text);
        diff += fmt::format("@@ line {} @@\n-{}\n+{}\n", update.line, line, changed);
    }
    return diff;
}

void apply_updates(const CheckItem& item, const std::vector<CheckUpdate>& updates) {
    std::string text = bytes_of(item.file);
    if (text != item.scenario->origin.text)
        throw WorldError(fmt::format("{} has changed since it was read; it is left as it is", item.file.string()));
    for (auto update = updates.rbegin(); update != updates.rend(); ++update)
        text.replace(update->begin, update->length, update->new_text);
    write_file(item.file, text);
}

}  // namespace waterlight
