// What `waterlight sweep` takes on the command line.
#pragma once

#include <CLI/CLI.hpp>

#include "app/sweep/options.hpp"

namespace waterlight {

/// Adds the subcommand "sweep" and fills `options` when the program's arguments are parsed.
void add_sweep(CLI::App& program, SweepOptions& options);

}  // namespace waterlight
