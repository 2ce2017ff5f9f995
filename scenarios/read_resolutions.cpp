#include "scenarios/read_resolutions.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace waterlight {

namespace {

/// The numbers of one value; empty where it is none or a list of anything else than whole numbers.
std::vector<double> numbers_of(const toml::node& value) {
    const auto is_allowed = [](double x) { return std::isfinite(x) && x > 0; };
    std::vector<double> numbers;
    if (value.is_number()) numbers.push_back(value.value<double>().value_or(0));
    if (const toml::array* list = value.as_array())
        for (const toml::node& element : *list)
            numbers.push_back(element.is_integer() ? element.value<double>().value_or(0) : 0);
    return std::all_of(numbers.begin(), numbers.end(), is_allowed) ? numbers : std::vector<double>{};
}

std::string toml_text(const toml::node& value) {
    std::ostringstream text;
    value.visit([&text](const auto& node) { text << toml::toml_formatter{node}; });
    return text.str();
}

bool is_count(const toml::node& value) { return !value.is_floating_point(); }

/// The place in the lists that varies.
std::optional<std::size_t> varied(const std::vector<std::vector<double>>& values) {
    for (std::size_t k = 0; k < values.front().size(); ++k)
        for (const std::vector<double>& value : values)
            if (value[k] != values.front()[k]) return k;
    return std::nullopt;
}

}  // namespace

std::optional<std::vector<Resolution>> read_resolutions(const toml::node& node) {
    const toml::array* list = node.as_array();
    if (!list || list->size() < 2) return std::nullopt;
    std::vector<std::vector<double>> values;
    for (const toml::node& value : *list) {
        values.push_back(numbers_of(value));
        const bool is_alike =
            values.back().size() == values.front().size() && is_count(value) == is_count(*list->get(0));
        if (values.back().empty() || !is_alike) return std::nullopt;
    }
    const std::optional<std::size_t> k = varied(values);
    if (!k) return std::nullopt;
    std::vector<Resolution> resolutions;
    for (std::size_t i = 0; i < values.size(); ++i)
        resolutions.push_back({toml_text(*list->get(i)), values[i][*k], is_count(*list->get(i))});
    return resolutions;
}

}  // namespace waterlight
