// The run-up line as a table.
#pragma once

#include <filesystem>
#include <span>

#include "sim/runup.hpp"

namespace waterlight {

/// A CSV file, whole or not at all: "line,x_m,y_m,elevation_m", one row a point in order along its line, the elevation
/// that of the ground. Lines are numbered from 0. Throws WorldError.
void write_runup(const std::filesystem::path& path, std::span<const RunupLine> lines);

}  // namespace waterlight
