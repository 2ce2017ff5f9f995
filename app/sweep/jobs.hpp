// A sweep in several processes.
#pragma once

#include <functional>

#include "app/sweep/settings.hpp"

namespace waterlight {

/// How many of options.jobs settings fit the memory that this machine has free, at least one; no more than
/// options.max_runs.
int jobs_at_once(const SweepOptions& options, const std::vector<Setting>& settings);

/// Starts this program so many times on the same sweep; together they share the threads and run what has not run.
/// `look` is called about ten times a second meanwhile. Throws WorldError where one of them fails.
void run_jobs(const SweepOptions& options, int jobs, const std::function<void()>& look);

}  // namespace waterlight
