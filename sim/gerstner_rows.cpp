// Rows of the Gerstner sea in float: Newton's iteration for all cells of a stretch at once, wave by wave, so that the
// compiler vectorises over the cells. The rare cell on which plain Newton does not arrive is left to the double solver.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "sim/gerstner.hpp"
#include "sim/sincos.hpp"

namespace waterlight {

namespace {

constexpr int stretch = 256;
using Values = std::array<float, stretch>;

// One Gerstner sum for each cell, as structure of arrays, and where the particles are.
struct Cells {
    Values away_x, away_y;  // A - x as tried
    Values shift_x, shift_y, elevation, rise_x, rise_y, xx, xy, yy;

    f32::Gerstner sums(std::size_t i) const {
        return {shift_x[i], shift_y[i], elevation[i], rise_x[i], rise_y[i], xx[i], xy[i], yy[i]};
    }
    // Distance by which the particle misses the cell, along the worse axis.
    float miss(std::size_t i) const {
        return f32::max(f32::abs(away_x[i] - shift_x[i]), f32::abs(away_y[i] - shift_y[i]));
    }
    void set(std::size_t i, const f32::Gerstner& sums) {
        shift_x[i] = sums.shift_x;
        shift_y[i] = sums.shift_y;
        elevation[i] = sums.elevation;
        rise_x[i] = sums.rise_x;
        rise_y[i] = sums.rise_y;
        xx[i] = sums.xx;
        xy[i] = sums.xy;
        yy[i] = sums.yy;
    }
};

// A wave along a stretch: its phase at each cell centre, reduced to a turn in double.
struct Phases {
    glm::vec2 k;
    glm::vec2 direction;
    float amplitude;
    Values at_rest;
};

Phases phases_of(const GerstnerWave& wave, const Grid& grid, int i0, int j, double time_s) {
    constexpr double turn = 2 * std::numbers::pi;
    Phases phases{wave.k, glm::normalize(wave.k), static_cast<float>(wave.amplitude_m), {}};
    const double first = wave.k.x * grid.x_m(i0) + wave.k.y * grid.y_m(j) - wave.omega * time_s + wave.phase;
    const double start = std::remainder(first, turn);
    const double step = wave.k.x * grid.dx_m;
#pragma GCC ivdep
    for (int i = 0; i < stretch; ++i) {
        const double theta = start + step * i;
        phases.at_rest[static_cast<std::size_t>(i)] =
            static_cast<float>(theta - turn * std::nearbyint(theta * (1 / turn)));
    }
    return phases;
}

void add_wave(const Phases& wave, Cells& cells) {
#pragma GCC ivdep
    for (std::size_t i = 0; i < stretch; ++i) {
        const SinCos theta = sincos_of(wave.at_rest[i] + wave.k.x * cells.away_x[i] + wave.k.y * cells.away_y[i]);
        cells.set(i,
                  f32::gerstner_add(cells.sums(i), wave.k, wave.direction, wave.amplitude, theta.sine, theta.cosine));
    }
}

void sum_waves(const std::vector<Phases>& waves, Cells& cells) {
    for (std::size_t i = 0; i < stretch; ++i) cells.set(i, f32::gerstner_none());
    for (const Phases& wave : waves) add_wave(wave, cells);
}

// Moves each particle by Newton's step; returns the farthest miss before it, m.
float correct(Cells& cells) {
    Values miss;
#pragma GCC ivdep
    for (std::size_t i = 0; i < stretch; ++i) {
        miss[i] = cells.miss(i);
        const glm::vec2 off{cells.away_x[i] - cells.shift_x[i], cells.away_y[i] - cells.shift_y[i]};
        const glm::vec2 step = f32::gerstner_solve(cells.sums(i), off);
        cells.away_x[i] -= step.x;
        cells.away_y[i] -= step.y;
    }
    return *std::max_element(miss.begin(), miss.end());
}

}  // namespace

void GerstnerSea::add_cells(const Grid& grid, int i0, int count, int j, double time_s, const Row& row) const {
    std::vector<Phases> waves;
    waves.reserve(waves_.size());
    for (const GerstnerWave& wave : waves_) waves.push_back(phases_of(wave, grid, i0, j, time_s));
    Cells cells{};
    // From a miss of 1e-3 one step more brings it to rounding.
    const float tolerance = 1e-3f * static_cast<float>(amplitude_sum_);
    const float accepted = 5e-6f * static_cast<float>(amplitude_sum_);
    const int most_steps = 8;
    float miss = 2 * tolerance;
    for (int n = 0; n < most_steps && !(miss <= tolerance); ++n) {
        sum_waves(waves, cells);
        miss = correct(cells);
    }
    sum_waves(waves, cells);
    const float raised = static_cast<float>(raised_);
    for (int i = 0; i < count; ++i) {
        const auto n = static_cast<std::size_t>(i);
        const glm::vec2 slope = f32::gerstner_solve(cells.sums(n), {cells.rise_x[n], cells.rise_y[n]});
        if (!(cells.miss(n) <= accepted)) {
            const SurfacePoint point = at({grid.x_m(i0 + i), grid.y_m(j)}, time_s);
            row.elevation[i0 + i] += static_cast<float>(point.elevation_m);
            row.slope_x[i0 + i] += static_cast<float>(point.slope.x);
            row.slope_y[i0 + i] += static_cast<float>(point.slope.y);
            continue;
        }
        row.elevation[i0 + i] += raised + cells.elevation[n];
        row.slope_x[i0 + i] += slope.x;
        row.slope_y[i0 + i] += slope.y;
    }
}

void GerstnerSea::add_row(const Grid& grid, int j, double time_s, const Row& row) const {
    for (int i0 = 0; i0 < grid.nx; i0 += stretch) {
        add_cells(grid, i0, std::min(stretch, grid.nx - i0), j, time_s, row);
    }
}

}  // namespace waterlight
