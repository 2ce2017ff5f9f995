// Scenarios as texts, for the tests of the reader.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scenarios/reader.hpp"

namespace waterlight::test {

/// The least that a scenario must say; lines 1 to 4.
inline const std::string least = "[domain]\nsize_m = [8.0, 6.0]\ncells = [64, 48]\ndepth_m = 2.0\n";

inline Scenario parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
    Scenario scenario = parse_scenario(text, "pool.toml", overrides);
    check_combinations(scenario);
    return scenario;
}

/// What the reader says about a text that it rejects.
inline std::string rejection(const std::string& text, const std::vector<std::string>& overrides = {}) {
    try {
        parse(text, overrides);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace waterlight::test
