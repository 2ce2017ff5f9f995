// Keys in words: what is allowed, and what holds.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "scenarios/check.hpp"
#include "scenarios/schema.hpp"

namespace waterlight {

namespace {

template <class... Ts>
struct Overloaded : Ts... {
    using Ts::operator()...;
};
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;

std::string with_range(std::string_view type, const Range& range) {
    const std::string limits = range.text();
    return limits.empty() ? std::string(type) : fmt::format("{} {}", type, limits);
}

std::string number_text(double x) {
    std::string text = fmt::format("{}", x);
    if (std::isfinite(x) && text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

std::string pair_text(const glm::dvec2& v) { return fmt::format("[{}, {}]", number_text(v.x), number_text(v.y)); }

}  // namespace

bool Range::contains(double x) const {
    return std::isfinite(x) && (excludes_low ? x > low : x >= low) && (excludes_high ? x < high : x <= high);
}

std::string Range::text() const {
    if (std::isinf(low) && std::isinf(high)) return {};
    if (std::isinf(high)) return fmt::format("{} {}", excludes_low ? ">" : ">=", low);
    if (std::isinf(low)) return fmt::format("{} {}", excludes_high ? "<" : "<=", high);
    return fmt::format("in {}{}, {}{}", excludes_low ? "(" : "[", low, high, excludes_high ? ")" : "]");
}

std::string allowed(const Key& key, const Target& target) {
    const auto number = [&](auto*) { return with_range("number", key.range); };
    const auto numbers = [&](const std::string& count) {
        return key.range.text().empty() ? count : with_range(count + ", each", key.range);
    };
    const auto text = [](auto*) { return std::string("text"); };
    return std::visit(
        Overloaded{[&](double* t) { return number(t); }, [&](std::optional<double>* t) { return number(t); },
                   [&](int*) { return with_range("integer", key.range); },
                   [&](std::uint64_t*) { return std::string("integer >= 0"); },
                   [](bool*) { return std::string("true or false"); }, [&](std::string* t) { return text(t); },
                   [&](std::optional<std::string>* t) { return text(t); },
                   [&](glm::dvec2*) { return numbers("two numbers"); },
                   [&](std::optional<glm::dvec2>*) { return numbers("two numbers"); },
                   [&](glm::ivec2*) {
                       return with_range("two integers, each", key.range) + (key.otherwise == "auto" ? " or auto" : "");
                   },
                   [&](glm::dvec3*) { return numbers("three numbers"); },
                   [&](std::optional<glm::ivec3>*) { return with_range("three integers, each", key.range); },
                   [](std::vector<std::string>*) { return std::string("list of texts"); },
                   [](std::vector<Resolution>*) {
                       return std::string("list of two values or more: numbers, or lists of as many whole numbers");
                   },
                   [&](std::vector<double>*) { return with_range("list of numbers, each", key.range); },
                   [](const Choice& c) { return fmt::format("one of {}", fmt::join(c.names, ", ")); },
                   [](const Words& w) { return fmt::format("list of {}", fmt::join(w.names, ", ")); }},
        target);
}

std::string value_text(const Target& target) {
    const auto quoted = [](const std::string& s) { return fmt::format("\"{}\"", s); };
    return std::visit(
        Overloaded{[](const double* v) { return number_text(*v); },
                   [](const std::optional<double>* v) { return *v ? number_text(**v) : std::string(); },
                   [](const int* v) { return fmt::format("{}", *v); },
                   [](const std::uint64_t* v) { return fmt::format("{}", *v); },
                   [](const bool* v) { return fmt::format("{}", *v); },
                   [&](const std::string* v) { return quoted(*v); },
                   [&](const std::optional<std::string>* v) { return *v ? quoted(**v) : std::string(); },
                   [](const glm::dvec2* v) { return pair_text(*v); },
                   [](const std::optional<glm::dvec2>* v) { return *v ? pair_text(**v) : std::string(); },
                   [](const glm::ivec2* v) { return fmt::format("[{}, {}]", v->x, v->y); },
                   [](const glm::dvec3* v) {
                       return fmt::format("[{}, {}, {}]", number_text(v->x), number_text(v->y), number_text(v->z));
                   },
                   [](const std::optional<glm::ivec3>* v) {
                       return *v ? fmt::format("[{}, {}, {}]", (*v)->x, (*v)->y, (*v)->z) : std::string();
                   },
                   [](const std::vector<std::string>* v) { return fmt::format("[{}]", fmt::join(*v, ", ")); },
                   [](const std::vector<Resolution>*) { return std::string("[]"); },
                   [](const std::vector<double>* v) {
                       return v->empty() ? std::string() : fmt::format("[{}]", fmt::join(*v, ", "));
                   },
                   [&](const Choice& c) { return quoted(std::string(c.names[static_cast<std::size_t>(c.selected)])); },
                   [](const Words& w) { return fmt::format("[{}]", fmt::join(*w.values, ", ")); }},
        target);
}

}  // namespace waterlight
