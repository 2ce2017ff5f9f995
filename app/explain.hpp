// What a scene needs, in plain words, before it is run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenarios/choose.hpp"

namespace waterlight {

/// A dozen lines: the waves, the model chosen and what speaks against the others, grid, time step, light, cost, and
/// whether the tolerance is met.
std::string explanation(const Scenario& scenario, const Decision& decision);

/// The same of a file with overrides. Throws InputError.
std::string explain_scenario(const std::filesystem::path& file, const std::vector<std::string>& overrides);

}  // namespace waterlight
