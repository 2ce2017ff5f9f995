// The values of a study of convergence, from TOML.
#pragma once

#include <toml++/toml.h>
#include <optional>
#include <vector>

#include "scenarios/check.hpp"

namespace waterlight {

/// At least two values of one kind: numbers > 0, or lists of as many whole numbers > 0. The size of a list is that of
/// its first number that differs from list to list. Nothing where the node is anything else, or nothing differs.
std::optional<std::vector<Resolution>> read_resolutions(const toml::node& node);

}  // namespace waterlight
