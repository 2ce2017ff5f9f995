#include "scenarios/table_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "scenarios/nearest.hpp"
#include "scenarios/value_reader.hpp"

namespace waterlight {

namespace {

/// The full key that ends in this name, or in one that differs by one edit.
std::string known_elsewhere(const std::string& name, const std::vector<std::string>& known) {
    for (int distance = 0; distance <= 1; ++distance)
        for (const std::string& key : known) {
            const std::string leaf = key.substr(key.rfind('.') + 1);
            if (leaf.size() > 3 && std::abs(static_cast<int>(leaf.size()) - static_cast<int>(name.size())) <= 1 &&
                edit_distance(name, leaf) == distance)
                return key;
        }
    return {};
}

}  // namespace

std::string ReadContext::place(std::string_view path, const toml::node* node) const {
    if (const Override* override = override_of(path)) return override->place();
    const std::string file = origin.file.string();
    if (!node) return file;
    if (!node->source().begin) {
        // A section that overrides alone have made.
        const auto maker = std::find_if(overrides.rbegin(), overrides.rend(), [&](const Override& o) {
            return o.key.size() > path.size() && o.key.compare(0, path.size(), path) == 0;
        });
        return maker == overrides.rend() ? file : maker->place();
    }
    const toml::source_position at = node->source().begin;
    return fmt::format("{}:{}:{}", file, at.line, at.column);
}

const Override* ReadContext::override_of(std::string_view path) const {
    const auto last =
        std::find_if(overrides.rbegin(), overrides.rend(), [&](const Override& o) { return o.covers(path); });
    return last == overrides.rend() ? nullptr : &*last;
}

TableReader::TableReader(ReadContext& context, const toml::table* table, std::string prefix)
    : context_(context), table_(table), prefix_(std::move(prefix)) {}

std::string TableReader::path_of(std::string_view name) const {
    return prefix_.empty() ? std::string(name) : fmt::format("{}.{}", prefix_, name);
}

const toml::node* TableReader::take(const Key& key) {
    names_.emplace_back(key.name);
    const toml::node* node = table_ ? table_->get(key.name) : nullptr;
    if (node) {
        const std::string path = path_of(key.name);
        context_.origin.places.insert_or_assign(path, context_.place(path, node));
    }
    return node;
}

void TableReader::value(const Key& key, Target target) {
    const toml::node* node = take(key);
    const std::string path = path_of(key.name);
    if (!node) {
        if (key.required) missing_.push_back({path, allowed(key, target)});
        return;
    }
    if (key.otherwise == "auto" && node->value<std::string_view>() == key.otherwise) return;
    const Override* override = context_.override_of(path);
    const std::string* raw = override && override->key == path ? &override->raw : nullptr;
    if (const auto wrong = read_value(key, target, *node, raw)) {
        std::string nearest;
        const Choice* choice = std::get_if<Choice>(&target);
        if (choice && node->is_string())
            nearest = nearest_word(*node->value<std::string>(), {choice->names.begin(), choice->names.end()});
        reject(context_.place(path, node), path, *wrong, allowed(key, target), nearest);
    }
}

void TableReader::section(const Key& key, const Inside& inside) {
    const toml::node* node = take(key);
    const std::string path = path_of(key.name);
    if (node && !node->is_table()) reject(context_.place(path, node), path, found_text(*node), "a section");
    read_table(node ? node->as_table() : nullptr, path, inside);
}

void TableReader::optional_section(const Key& key, const Inside& inside) {
    const toml::node* node = take(key);
    if (!node) return;
    const std::string path = path_of(key.name);
    const bool states_none = !key.otherwise.empty() && node->value<std::string_view>() == key.otherwise;
    if (states_none) return;
    if (!node->is_table())
        reject(context_.place(path, node), path, found_text(*node),
               key.otherwise.empty() ? "a section" : fmt::format("\"{}\" or a section", key.otherwise));
    read_table(node->as_table(), path, inside);
}

void TableReader::list(const Key& key, const std::vector<Shape>& shapes) {
    const toml::node* node = take(key);
    if (!node) return;
    const std::string path = path_of(key.name);
    const toml::array* elements = node->as_array();
    if (!elements) reject(context_.place(path, node), path, found_text(*node), fmt::format("sections [[{}]]", path));
    for (std::size_t i = 0; i < elements->size(); ++i)
        read_element(*elements->get(i), fmt::format("{}[{}]", path, i), shapes);
}

void TableReader::read_element(const toml::node& element, const std::string& path,
                               const std::vector<Shape>& shapes) const {
    const toml::table* table = element.as_table();
    if (!table) reject(context_.place(path, &element), path, found_text(element), "a section");
    context_.origin.places.insert_or_assign(path, context_.place(path, &element));
    if (shapes.size() == 1) {
        read_table(table, path, shapes.front().visit);
        return;
    }
    Choice types{.names = {}, .selected = 0, .select = {}};
    for (const Shape& shape : shapes) types.names.push_back(shape.type);
    std::size_t type = 0;
    types.select = [&type](int i) { type = static_cast<std::size_t>(i); };
    // The type is read first, by itself: it says what the other keys are.
    TableReader by_itself(context_, table, path);
    by_itself.value({.name = "type", .required = true}, types);
    by_itself.reject_missing();
    read_table(table, path, [&](Visitor& in) {
        in.value({.name = "type"}, types);
        shapes[type].visit(in);
    });
}

void TableReader::read_table(const toml::table* table, const std::string& path, const Inside& inside) const {
    TableReader reader(context_, table, path);
    inside(reader);
    reader.finish();
}

void TableReader::reject_unknown(const std::string& name, const toml::node& node) const {
    const std::string path = path_of(name);
    std::string nearest = nearest_word(name, names_);
    if (nearest.empty()) nearest = known_elsewhere(name, context_.known);
    reject(context_.place(path, &node), path, "an unknown key", fmt::format("{}", fmt::join(names_, ", ")), nearest);
}

void TableReader::reject_missing() const {
    if (missing_.empty()) return;
    const Missing& first = missing_.front();
    reject(context_.place(prefix_, table_), first.path, "nothing", first.allowed + " (required)");
}

// An unknown key comes first: it may be the misspelling of the missing one.
void TableReader::finish() const {
    if (table_)
        for (const auto& [name, node] : *table_)
            if (std::find(names_.begin(), names_.end(), name.str()) == names_.end())
                reject_unknown(std::string(name.str()), node);
    reject_missing();
}

}  // namespace waterlight
