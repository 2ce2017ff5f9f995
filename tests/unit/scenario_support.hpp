// Scenarios as texts, for the tests of the reader.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scenarios/reader.hpp"

namespace waterlight::test {

/// The least that a scenario must say; lines 1 to 4.
inline const std::string least = "[domain]\nsize_m = [8.0, 6.0]\ncells = [64, 48]\ndepth_m = 2.0\n";

/// Sections that many add.
inline const std::string floor_map = "[caustics.floor]\npixels = [64, 48]\n",
                         shallow_water = "[waves]\nmodel = \"shallow-water\"\n";

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

/// A text that the reader must reject.
struct Bad {
    const char* name;
    const char* text;    ///< after `least`, which has four lines
    const char* begins;  ///< of the message
    const char* contains;
};

/// One line with the place, the key, what was found and what is allowed.
inline void expect_rejection(const Bad& bad) {
    const std::string message = rejection(least + bad.text);
    EXPECT_EQ(message.rfind(bad.begins, 0), 0U) << message;
    EXPECT_NE(message.find(bad.contains), std::string::npos) << message;
    EXPECT_NE(message.find("found "), std::string::npos) << message;
    EXPECT_NE(message.find("; allowed: "), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

}  // namespace waterlight::test
