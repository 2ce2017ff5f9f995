// Reads a scenario.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/scenario.hpp"

namespace waterlight {

/// The scenario in `file` with the overrides ("key=value") laid over it, checked: every key and value, the combination
/// of all, the data files it names (their paths then hold where they were found), and that it fits this machine's
/// memory. What it leaves open is chosen (scenarios/choose.hpp). Throws InputError with one line: FILE:LINE:COL (or
/// --set KEY=VALUE): KEY: found X; allowed: Y.
Scenario read_scenario(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The same of the text that another scenario came from, whatever its file holds by now, with these overrides in place
/// of its own.
Scenario read_again(const Origin& origin, const std::vector<std::string>& overrides);

/// The same before anything is chosen: is_open() where it leaves something to settle().
Scenario read_open_scenario(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// As read_open_scenario() from a text; `file` names it in errors. Keys and values only: no combinations, files or
/// memory.
Scenario parse_scenario(std::string_view text, const std::filesystem::path& file,
                        const std::vector<std::string>& overrides = {});

/// Throws InputError where keys that are right by themselves do not go together.
void check_combinations(const Scenario& scenario);

/// Measured data that a scenario needs is not on this machine: the file lies in a folder below $WATERLIGHT_DATA, and
/// the folder is not there.
struct MissingData : InputError {
    using InputError::InputError;
};

/// Replaces the paths of data files by where they are: beside the scenario, else below $WATERLIGHT_DATA. Throws
/// InputError naming both where there is none, MissingData where the folder is not there either.
void find_data(Scenario& scenario);

/// Reads the meshes that find_data() found and makes the objects ready for light. Throws InputError where an object is
/// none.
void read_data(Scenario& scenario);

/// What a scenario that lies in `folder` must say of its data files ("key=value") to find those of this one, whose
/// find_data() was called: nothing where it finds them as it is.
std::vector<std::string> data_overrides(const Scenario& scenario, const std::filesystem::path& folder);

/// The files that find_data() found.
std::vector<std::filesystem::path> data_files(const Scenario& scenario);

}  // namespace waterlight
