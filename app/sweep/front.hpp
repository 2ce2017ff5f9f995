// Which settings are worth their time.
#pragma once

#include <optional>
#include <vector>

namespace waterlight {

/// What a setting costs and how wrong it is; not a number where it failed.
struct CostAndError {
    double time_s = 0;
    double error = 0;
};

/// The Pareto front: those that no other setting beats in time without being more wrong, nor the other way round. In
/// order of time; of equals the first.
std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& settings);

/// The cheapest setting whose error is at most `tolerance`; none where there is none.
std::optional<std::size_t> cheapest_within(const std::vector<CostAndError>& settings, double tolerance);

/// The least wrong; none where all failed.
std::optional<std::size_t> least_wrong(const std::vector<CostAndError>& settings);

}  // namespace waterlight
