// The settings of a sweep: the product of what is varied.
#pragma once

#include "app/sweep/options.hpp"
#include "scenarios/scenario.hpp"

namespace waterlight {

/// One --vary: a key and the values that it takes, as typed.
struct Variation {
    std::string key;
    std::vector<std::string> values;
};

/// "key=v1,v2": the values end at commas outside of brackets, braces and quotation marks. Throws InputError where there
/// is no key, no value, or one value twice.
Variation parse_variation(const std::string& text);

struct Setting {
    std::vector<std::string> values;     ///< one for each variation
    std::vector<std::string> overrides;  ///< those of every setting, then its own
    std::vector<std::string> scene;      ///< without what is varied of methods: settings with the same answer the same
                                         ///< question
    std::vector<std::string> waves;      ///< without what is varied of the light's methods: the surface is the same
    Scenario scenario;
};

/// Whether a key chooses how the waves are computed, not which.
bool is_method_of_waves(std::string_view key);
/// Whether a key chooses how the light is computed, not which.
bool is_method_of_light(std::string_view key);

/// All settings, the last variation fastest. Throws InputError, naming the --vary or --set, where one of them is no
/// valid scenario.
std::vector<Setting> settings_of(const SweepOptions& options, const std::vector<Variation>& variations);

/// "key=value key=value" of what is varied.
std::string text_of(const std::vector<Variation>& variations, const Setting& setting);

}  // namespace waterlight
