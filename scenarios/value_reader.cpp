#include "scenarios/value_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenarios/origin.hpp"
#include "scenarios/read_resolutions.hpp"
#include "sim/message.hpp"

namespace waterlight {

namespace {

/// A whole number may have more digits than a double keeps: toml++ gives no double then.
double number_of(const toml::node& node) {
    const toml::value<std::int64_t>* whole = node.as_integer();
    return whole ? static_cast<double>(whole->get()) : *node.value<double>();
}

std::optional<double> number_in(const Range& range, const toml::node& node) {
    if (!node.is_number()) return std::nullopt;
    const double x = number_of(node);
    return range.contains(x) ? std::optional(x) : std::nullopt;
}

std::optional<int> integer_in(const Range& range, const toml::node& node) {
    if (!node.is_integer()) return std::nullopt;
    const std::int64_t x = *node.value<std::int64_t>();
    const bool fits = x >= std::numeric_limits<int>::min() && x <= std::numeric_limits<int>::max();
    return fits && range.contains(static_cast<double>(x)) ? std::optional(static_cast<int>(x)) : std::nullopt;
}

std::optional<std::string> text_of(const toml::node& node, const std::string* raw) {
    if (node.is_string()) return *node.value<std::string>();
    if (raw && !node.is_array() && !node.is_table()) return *raw;
    return std::nullopt;
}

/// Reads into a target; each overload returns whether the value was allowed.
struct Reading {
    const Key& key;
    const toml::node& node;
    const std::string* raw;

    template <class T, class V>
    static bool store(T* target, const std::optional<V>& value) {
        if (value) *target = *value;
        return value.has_value();
    }

    bool operator()(double* t) const { return store(t, number_in(key.range, node)); }
    bool operator()(std::optional<double>* t) const { return store(t, number_in(key.range, node)); }
    bool operator()(int* t) const { return store(t, integer_in(key.range, node)); }
    bool operator()(std::uint64_t* t) const {
        if (!node.is_integer() || *node.value<std::int64_t>() < 0) return false;
        *t = static_cast<std::uint64_t>(*node.value<std::int64_t>());
        return true;
    }
    bool operator()(bool* t) const { return store(t, node.is_boolean() ? node.value<bool>() : std::nullopt); }
    bool operator()(std::string* t) const { return store(t, text_of(node, raw)); }
    bool operator()(std::optional<std::string>* t) const { return store(t, text_of(node, raw)); }
    bool operator()(glm::dvec2* t) const { return store(t, pair<glm::dvec2>(number_in)); }
    bool operator()(std::optional<glm::dvec2>* t) const { return store(t, pair<glm::dvec2>(number_in)); }
    bool operator()(glm::ivec2* t) const { return store(t, pair<glm::ivec2>(integer_in)); }
    bool operator()(glm::dvec3* t) const { return store(t, triple<glm::dvec3>(number_in)); }
    bool operator()(std::optional<glm::ivec3>* t) const { return store(t, triple<glm::ivec3>(integer_in)); }
    bool operator()(std::vector<std::string>* t) const {
        const toml::array* list = node.as_array();
        if (!list) return false;
        std::vector<std::string> texts;
        for (const toml::node& element : *list) {
            if (!element.is_string()) return false;
            texts.push_back(*element.value<std::string>());
        }
        *t = texts;
        return true;
    }
    bool operator()(std::vector<Resolution>* t) const { return store(t, read_resolutions(node)); }
    bool operator()(std::vector<double>* t) const {
        const toml::array* list = node.as_array();
        if (!list || list->empty()) return false;
        std::vector<double> values;
        for (const toml::node& element : *list) {
            const auto one = number_in(key.range, element);
            if (!one) return false;
            values.push_back(*one);
        }
        *t = values;
        return true;
    }
    bool operator()(const Choice& choice) const {
        const auto index = index_in(choice.names, text_of(node, raw));
        if (index) choice.select(static_cast<int>(*index));
        return index.has_value();
    }
    bool operator()(const Words& words) const {
        const toml::array* list = node.as_array();
        if (!list) return false;
        std::vector<std::string> values;
        for (const toml::node& element : *list) {
            const auto index = index_in(words.names, text_of(element, nullptr));
            if (!index) return false;
            values.emplace_back(words.names[*index]);
        }
        *words.values = values;
        return true;
    }

  private:
    template <class Vec, class ReadOne>
    std::optional<Vec> pair(ReadOne read_one) const {
        const toml::array* list = node.as_array();
        if (!list || list->size() != 2) return std::nullopt;
        const auto x = read_one(key.range, *list->get(0)), y = read_one(key.range, *list->get(1));
        if (!x || !y) return std::nullopt;
        return Vec(*x, *y);
    }

    template <class Vec, class ReadOne>
    std::optional<Vec> triple(ReadOne read_one) const {
        const toml::array* list = node.as_array();
        if (!list || list->size() != 3) return std::nullopt;
        Vec values{};
        for (int i = 0; i < 3; ++i) {
            const auto one = read_one(key.range, *list->get(static_cast<std::size_t>(i)));
            if (!one) return std::nullopt;
            values[i] = *one;
        }
        return values;
    }

    static std::optional<std::size_t> index_in(const std::vector<std::string_view>& names,
                                               const std::optional<std::string>& word) {
        if (!word) return std::nullopt;
        const auto at = std::find(names.begin(), names.end(), *word);
        if (at == names.end()) return std::nullopt;
        return static_cast<std::size_t>(at - names.begin());
    }
};

std::string list_text(const toml::array& list) {
    constexpr std::size_t longest = 4;
    const bool nests = std::any_of(list.begin(), list.end(),
                                   [](const toml::node& element) { return element.is_table() || element.is_array(); });
    if (nests || list.size() > longest) return fmt::format("a list of {}", list.size());
    std::vector<std::string> elements;
    for (const toml::node& element : list) elements.push_back(found_text(element));
    return fmt::format("[{}]", fmt::join(elements, ", "));
}

}  // namespace

std::optional<std::string> read_value(const Key& key, const Target& target, const toml::node& node,
                                      const std::string* raw) {
    if (std::visit(Reading{key, node, raw}, target)) return std::nullopt;
    return found_text(node);
}

std::string found_text(const toml::node& node) {
    if (const toml::table* table = node.as_table()) return fmt::format("a table of {}", table->size());
    if (const toml::array* list = node.as_array()) return list_text(*list);
    if (node.is_string()) return fmt::format("\"{}\"", shortened(*node.value<std::string_view>(), 60));
    if (node.is_floating_point() && !std::isfinite(*node.value<double>()))
        return fmt::format("{}, which is not finite", *node.value<double>());
    if (const toml::value<std::int64_t>* whole = node.as_integer()) return fmt::format("{}", whole->get());
    if (node.is_number()) return fmt::format("{}", *node.value<double>());
    if (node.is_boolean()) return *node.value<bool>() ? "true" : "false";
    return "a date or a time";
}

}  // namespace waterlight
