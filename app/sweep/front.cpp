#include "app/sweep/front.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace waterlight {

std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& settings) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < settings.size(); ++i)
        if (std::isfinite(settings[i].time_s) && std::isfinite(settings[i].error)) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        if (settings[a].time_s != settings[b].time_s) return settings[a].time_s < settings[b].time_s;
        return settings[a].error < settings[b].error;
    });
    std::vector<std::size_t> front;
    for (const std::size_t i : order)
        if (front.empty() || settings[i].error < settings[front.back()].error) front.push_back(i);
    return front;
}

std::optional<std::size_t> cheapest_within(const std::vector<CostAndError>& settings, double tolerance) {
    for (const std::size_t i : pareto_front(settings))
        if (settings[i].error <= tolerance) return i;
    return std::nullopt;
}

std::optional<std::size_t> least_wrong(const std::vector<CostAndError>& settings) {
    const std::vector<std::size_t> front = pareto_front(settings);
    return front.empty() ? std::nullopt : std::optional(front.back());
}

}  // namespace waterlight
