// What the descriptions of the schema share: ranges, and ways to fill lists and choices.
#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "scenarios/schema.hpp"

namespace waterlight::schema {

constexpr Range positive{.low = 0, .excludes_low = true};
constexpr Range not_negative{.low = 0};
constexpr Range fractions{.low = 0, .high = 1};
constexpr Range circle{.low = -360, .high = 360};

/// The names follow the order of the enumeration.
template <class E>
Choice choice(E& value, std::vector<std::string_view> names) {
    return {std::move(names), static_cast<int>(value), [&value](int i) { value = static_cast<E>(i); }};
}

/// As choice(), with a word in front for "none".
template <class E>
Choice choice_or(std::string_view none, std::optional<E>& value, std::vector<std::string_view> names) {
    names.insert(names.begin(), none);
    return {std::move(names), value ? static_cast<int>(*value) + 1 : 0, [&value](int i) {
                if (i == 0)
                    value.reset();
                else
                    value = static_cast<E>(i - 1);
            }};
}

template <class T, class Describe>
Visitor::Inside into(std::optional<T>& value, Describe describe_one) {
    return [&value, describe_one](Visitor& v) {
        T stated;
        describe_one(v, stated);
        value = stated;
    };
}

template <class T, class List, class Describe>
Visitor::Inside append(List& values, Describe describe_one) {
    return [&values, describe_one](Visitor& v) {
        T stated;
        describe_one(v, stated);
        values.push_back(stated);
    };
}

}  // namespace waterlight::schema
