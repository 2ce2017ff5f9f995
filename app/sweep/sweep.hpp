// Runs a scenario over a product of settings, measures what each costs and how wrong it is.
#pragma once

#include "app/sweep/options.hpp"

namespace waterlight {

/// Writes below options.out: settings/*.json, one for each setting that has run, by a hash of all that it depends on;
/// reference/ and truth/, what they are judged against; and, but for a part, sweep.csv, sweep.md, sweep.svg, sweep.png.
/// What is there already is not computed again. Returns whether a setting meets options.tolerance, or true where some
/// have not run yet or none is asked for. Throws InputError before anything is written, WorldError and gpu::Error at
/// any time.
bool sweep(const SweepOptions& options);

}  // namespace waterlight
