#include "app/wave_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/readings.hpp"
#include "scenarios/resolve.hpp"

namespace waterlight {

namespace {

/// The scenario on cells * factor, at least 2 along an axis that has them.
BuiltModel on_cells(Scenario scenario, double factor, const BackendDecision& backend) {
    glm::ivec2& n = scenario.domain.cells;
    const auto scaled = [factor](int count) {
        return count == 1 ? 1 : std::max(2, static_cast<int>(std::lround(count * factor)));
    };
    n = {scaled(n.x), scaled(n.y)};
    return build_model(scenario, backend.context);
}

bool is_wet(const Surface& surface, std::size_t n) { return !surface.depth || surface.depth->data()[n] > 0; }

/// Over wet cells.
double rms(const Surface& surface, const Field<float>& field) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t n = 0; n < field.size(); ++n) {
        if (!is_wet(surface, n)) continue;
        sum += static_cast<double>(field.data()[n]) * field.data()[n];
        ++count;
    }
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

}  // namespace

WaveEstimate::WaveEstimate(const Scenario& scenario, const BackendDecision& backend)
    : is_finer_(resolve_model(scenario).model == ModelChoice::airy),
      gain_(resolve_model(scenario).model == ModelChoice::shallow_water ? Gain{2, 4} : Gain{4, 4}) {
    others_.push_back(on_cells(scenario, is_finer_ ? 3 : 0.5, backend));
    if (gain_.least < gain_.most) others_.push_back(on_cells(scenario, 0.25, backend));
}

void WaveEstimate::advance(double seconds) {
    for (BuiltModel& other : others_) other.model->advance(seconds);
}

void WaveEstimate::disturb(std::span<const Disturbance> disturbances) {
    for (BuiltModel& other : others_) other.model->disturb(disturbances);
}

void WaveEstimate::set_rain(std::span<const Rain> rain) {
    for (BuiltModel& other : others_) other.model->set_rain(rain);
}

void WaveEstimate::exchange_state(StateArchive& state) {
    for (BuiltModel& other : others_) other.model->exchange_state(state);
}

/// The surface less the other's, at the surface's wet cells.
Field<float> WaveEstimate::difference(const Surface& finer, WaveModel& other) const {
    const Surface& coarser = other.surface();
    const Grid& g = finer.grid;
    Field<float> d(g.nx, g.ny);
#pragma omp parallel for schedule(static)
    for (int j = 0; j < g.ny; ++j) {
        for (int i = 0; i < g.nx; ++i) {
            const std::size_t n = static_cast<std::size_t>(j) * g.nx + i;
            if (!is_wet(finer, n)) continue;
            const double there = elevation_at(coarser, {g.x_m(i), g.y_m(j)});
            d(i, j) = static_cast<float>(finer.elevation(i, j) - there);
        }
    }
    return d;
}

void WaveEstimate::compute(const Surface& surface) {
    error_ = difference(surface, *others_[0].model);
    if (!is_finer_) {
        double gain = gain_.most;
        if (others_.size() > 1) {
            // |u_2h - u_4h| / |u_h - u_2h|, both on the grid of u_h.
            Field<float> further = difference(surface, *others_[1].model);
            for (std::size_t n = 0; n < further.size(); ++n) further.data()[n] -= error_.data()[n];
            const double near = rms(surface, error_);
            gain = near > 0 ? std::clamp(rms(surface, further) / near, gain_.least, gain_.most) : gain_.most;
        }
        // u_h - u = e, u_2h - u = gain e.
        for (float& e : error_.values()) e /= static_cast<float>(1 - gain);
    }
    const double size = rms(surface, surface.elevation);
    rmse_ = size > 0 ? rms(surface, error_) / size : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace waterlight
