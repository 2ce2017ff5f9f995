#include "scenarios/rewrite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "scenarios/overrides.hpp"
#include "scenarios/toml_text.hpp"

namespace waterlight {

namespace {

std::string key_text(std::string_view name) {
    const auto bare = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    };
    const bool is_bare = !name.empty() && std::all_of(name.begin(), name.end(), bare);
    return is_bare ? std::string(name) : fmt::format("\"{}\"", name);
}

/// A node as it stands after "=", in one line. Numbers with the digits that they need and no more.
std::string inline_text(const toml::node& node) {
    if (const toml::table* table = node.as_table()) {
        std::string text;
        for (const auto& [name, value] : *table)
            text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", key_text(name.str()), inline_text(value));
        return text.empty() ? "{}" : fmt::format("{{ {} }}", text);
    }
    if (const toml::array* array = node.as_array()) {
        std::string text;
        for (const toml::node& element : *array) text += (text.empty() ? "" : ", ") + inline_text(element);
        return fmt::format("[{}]", text);
    }
    if (const toml::value<double>* number = node.as_floating_point()) {
        const std::string text = fmt::format("{}", number->get());
        return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
    }
    std::ostringstream text;
    text << toml::toml_formatter(node,
                                 toml::toml_formatter::default_flags & ~toml::format_flags::allow_literal_strings);
    return text.str();
}

/// Where a line and column of toml++ (from 1, in code points) are in a text.
std::size_t offset_of(std::string_view text, toml::source_position at) {
    std::size_t offset = 0;
    for (toml::source_index line = 1; line < at.line; ++line) offset = text.find('\n', offset) + 1;
    const auto is_continuation = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
    for (toml::source_index column = 1; column < at.column && offset < text.size(); ++column) {
        ++offset;
        while (offset < text.size() && is_continuation(text[offset])) ++offset;
    }
    return offset;
}

std::string replaced(std::string_view text, const toml::source_region& region, const std::string& by) {
    const std::size_t begin = offset_of(text, region.begin), end = offset_of(text, region.end);
    return std::string(text.substr(0, begin)) + by + std::string(text.substr(end));
}

std::string with_line_after(std::string_view text, const toml::source_region& region, const std::string& line) {
    const std::size_t end = std::min(text.find('\n', offset_of(text, region.end)), text.size());
    return fmt::format("{}\n{}{}", text.substr(0, end), line, text.substr(end));
}

std::string with_line_before_sections(std::string_view text, const std::string& line) {
    std::size_t at = 0;
    while (at < text.size() && text[at] != '[') at = std::min(text.find('\n', at), text.size() - 1) + 1;
    return fmt::format("{}{}\n{}", text.substr(0, at), line, text.substr(at));
}

std::string with_section(std::string_view text, const std::string& header, const toml::table& keys) {
    std::string all(text);
    if (!all.empty() && all.back() != '\n') all += '\n';
    all += fmt::format("\n{}\n", header);
    for (const auto& [name, value] : keys) all += fmt::format("{} = {}\n", key_text(name.str()), inline_text(value));
    return all;
}

/// How far a key's steps lead in a table.
struct Found {
    const toml::node* node;  ///< the last that is there
    std::size_t steps = 0;   ///< that lead to it
    std::string path;        ///< of it, as headers have it
};

Found find(const toml::table& root, const std::vector<KeyStep>& steps) {
    Found found{&root, 0, ""};
    for (const KeyStep& step : steps) {
        const toml::table* table = found.node->as_table();
        const toml::node* next = table ? table->get(step.name) : nullptr;
        if (next && step.index) {
            const toml::array* list = next->as_array();
            if (list && *step.index >= list->size()) {
                found.node = next;
                return found;
            }
            next = list ? list->get(*step.index) : nullptr;
        }
        if (!next) return found;
        found.node = next;
        ++found.steps;
        found.path += (found.path.empty() ? "" : ".") + step.name;
    }
    return found;
}

/// Whether the table begins with its own header, and not with that of a section within it.
bool has_header(std::string_view text, const toml::table& table, const std::string& path) {
    std::string_view line = text.substr(offset_of(text, table.source().begin));
    line = line.substr(0, line.find('\n'));
    return line.starts_with(fmt::format("[{}]", path)) || line.starts_with(fmt::format("[[{}]]", path));
}

std::string joined(const std::string& path, const std::vector<KeyStep>& steps, std::size_t from) {
    std::string all = path;
    for (std::size_t n = from; n < steps.size(); ++n) all += (all.empty() ? "" : ".") + steps[n].name;
    return all;
}

/// The text with one override laid over it in place, or what does not say the same.
std::string laid_over(std::string_view text, const Override& o) {
    const toml::table root = parse_toml(text), stated = stated_value(o);
    const toml::node& value = *stated.get("value");
    const std::vector<KeyStep> steps = key_steps(o);
    const Found found = find(root, steps);
    const std::string last = fmt::format("{} = {}", key_text(steps.back().name), inline_text(value));
    if (found.steps == steps.size()) return replaced(text, found.node->source(), inline_text(value));
    const toml::table* parent = found.node->as_table();
    const bool is_next = found.steps + 1 == steps.size(), ends_in_list = steps.back().index.has_value();
    if (const toml::table* keys = value.as_table(); keys && (is_next || !ends_in_list)) {
        const std::string path = joined(found.path, steps, found.steps);
        const bool is_inline = parent && parent->is_inline();
        const std::string header = ends_in_list ? fmt::format("[[{}]]", path) : fmt::format("[{}]", path);
        if (!is_inline) return with_section(text, header, *keys);
    }
    if (!parent) return std::string(text);
    if (parent->is_inline()) {
        toml::table changed = *parent;
        Override inner = o;
        inner.key = joined("", steps, found.steps);
        apply_override(changed, inner);
        return replaced(text, parent->source(), inline_text(changed));
    }
    if (is_next && parent == &root) return with_line_before_sections(text, last);
    if (is_next && has_header(text, *parent, found.path)) return with_line_after(text, parent->source(), last);
    const std::vector<KeyStep> section(steps.begin(), steps.end() - 1);
    return with_section(text, fmt::format("[{}]", joined(found.path, section, found.steps)),
                        toml::table{{steps.back().name, value}});
}

std::string written_anew(const toml::table& root) {
    std::ostringstream text;
    text << "# Written by a program: the comments of the scenario that it was made from are not here.\n"
         << toml::toml_formatter{root} << "\n";
    return text.str();
}

/// Whether a text says what the table says.
bool says(std::string_view text, const toml::table& root) {
    try {
        return parse_toml(text) == root;
    } catch (const toml::parse_error&) {
        return false;
    }
}

}  // namespace

std::string rewritten(std::string_view text, const std::vector<std::string>& overrides) {
    toml::table root = parse_toml(text);
    std::string changed(text);
    for (const std::string& each : overrides) {
        const Override override = parse_override(each);
        apply_override(root, override);
        const std::string next = laid_over(changed, override);
        changed = says(next, root) ? next : written_anew(root);
    }
    return changed;
}

}  // namespace waterlight
