#include "sim/shallow_disturbance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/error.hpp"
#include "sim/kernels/linear.hpp"
#include "sim/kernels/shallow_water.hpp"
#include "sim/shallow_check.hpp"
#include "sim/shallow_sides.hpp"

namespace waterlight {

namespace {

/// Depth (m) of the initial water in the cell at a place.
double depth_at(const ShallowWaterSettings& s, glm::dvec2 at_m) {
    const auto cell = [](double place, double low, double size, int n) {
        return std::clamp(static_cast<int>(std::floor((place - low) / size)), 0, n - 1);
    };
    return initial_depth_m(s, cell(at_m.x, s.grid.x0_m, s.grid.dx_m, s.grid.nx),
                           cell(at_m.y, s.grid.y0_m, s.grid.dy_m, s.grid.ny));
}

/// What one value of a patch may do to a cell of depth h.
double allowed(double gain_m, double h) { return h > 0 ? std::max(gain_m, -h) : 0; }

}  // namespace

ShallowSources::ShallowSources(const ShallowWaterSettings& s)
    : grid_(s.grid), boundary_(boundary_of(s.sides)), sources_(s.sources) {
    for (const Source& source : sources_) {
        const auto* maker = std::get_if<Wavemaker>(&source);
        if (!maker) continue;
        const double depth = depth_at(s, 0.5 * (maker->from_m + maker->to_m));
        if (!(depth > 0)) throw InputError("wavemaker: found dry ground in its middle; allowed: water");
        const double speed = f64::long_wave_speed(s.water.gravity_m_s2, depth);
        const double k = 2 * std::numbers::pi / (maker->period_s * speed);
        makers_.push_back({*maker, inflow_shape(carried_on(*maker, grid_), grid_, k, speed)});
    }
}

std::vector<Drop> ShallowSources::drops_in(double from_s, double to_s) const {
    std::vector<Drop> found;
    for (const Source& source : sources_) {
        if (const auto* drop = std::get_if<Drop>(&source)) {
            const bool at_start = to_s == 0 && drop->time_s == 0;
            if (at_start || (drop->time_s > from_s && drop->time_s <= to_s)) found.push_back(*drop);
        } else if (const auto* rain = std::get_if<Rain>(&source)) {
            for (const Drop& fallen : drops_of(*rain, grid_, from_s, to_s)) found.push_back(fallen);
        }
    }
    return found;
}

std::vector<DropPatch> ShallowSources::between(double from_s, double to_s) const {
    std::vector<DropPatch> patches;
    for (const Drop& drop : drops_in(from_s, to_s)) patches.push_back(drop_patch(drop, grid_, boundary_));
    for (const Maker& m : makers_) {
        const double amount = (to_s - from_s) * inflow_signal(m.maker, 0.5 * (from_s + to_s));
        if (amount == 0) continue;
        DropPatch patch{0, 0, m.inflow_m_s.clone()};
        for (double& value : patch.elevation_m.values()) value *= amount;
        patches.push_back(std::move(patch));
    }
    return patches;
}

template <class Real>
void disturb(const DropPatch& patch, const ShallowStart<Real>& start, ShallowFields<Real>& fields) {
    const Field<double>& gain = patch.elevation_m;
    const auto for_cells = [&](auto work) {
        for (int j = 0; j < gain.ny(); ++j) {
            const int row = patch.j0 + j;
            for (int i = 0; i < gain.nx(); ++i) {
                const int at = patch.i0 + i;
                const double h = static_cast<double>(start.depth.row(row)[at]) + fields.rise.row(row)[at];
                work(row, at, h, allowed(gain(i, j), h));
            }
        }
    };
    double raised = 0, dug = 0;
    for_cells([&](int, int, double, double value) { (value > 0 ? raised : dug) += std::abs(value); });
    const double moved = std::min(raised, dug);
    const double up = raised > 0 ? moved / raised : 0, down = dug > 0 ? moved / dug : 0;
    for_cells([&](int row, int at, double h, double value) {
        const double change = (value > 0 ? up : down) * value;
        Real& rise = fields.rise.row(row)[at];
        rise = std::max(static_cast<Real>(rise + change), -start.depth.row(row)[at]);
        const Real kept = static_cast<Real>(f64::kept_flow(h, std::max(h + change, 0.0)));
        fields.qx.row(row)[at] *= kept;
        fields.qy.row(row)[at] *= kept;
    });
}

template void disturb<float>(const DropPatch&, const ShallowStart<float>&, ShallowFields<float>&);
template void disturb<double>(const DropPatch&, const ShallowStart<double>&, ShallowFields<double>&);

}  // namespace waterlight
