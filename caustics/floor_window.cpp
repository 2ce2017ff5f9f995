// The window that a floor map needs: how far light is displaced, and how far from there its footprint reaches.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "caustics/floor_frame.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

/// How far the light of a surface's cells goes, in pixels, and by how much at most it differs between neighbours along
/// the domain's x and y.
struct Displacements {
    glm::vec2 largest{0, 0};
    glm::vec2 along_x{0, 0};
    glm::vec2 along_y{0, 0};

    void include(const Displacements& other) {
        largest = glm::max(largest, other.largest);
        along_x = glm::max(along_x, other.along_x);
        along_y = glm::max(along_y, other.along_y);
    }
};

/// Displacements of a row of cells; zero where no light enters.
struct DisplacedRow {
    std::vector<float> x, y;
    explicit DisplacedRow(int nx) : x(nx), y(nx) {}

    void land(const f32::FloorLight& light, const Surface& surface, int j, float raise_m) {
        const float* __restrict elevation = surface.elevation.row(j);
        const float* __restrict slope_x = surface.slope_x.row(j);
        const float* __restrict slope_y = surface.slope_y.row(j);
        float* __restrict to_x = x.data();
        float* __restrict to_y = y.data();
        const int nx = surface.grid.nx;
#pragma GCC ivdep
        for (int i = 0; i < nx; ++i) {
            const f32::FloorSample s =
                f32::land_on_floor(light, elevation[i] + raise_m, f32::real2(slope_x[i], slope_y[i]));
            const float lit = s.incident > 0 ? 1.0F : 0.0F;
            to_x[i] = lit * s.displacement.x;
            to_y[i] = lit * s.displacement.y;
        }
    }
};

float largest_of(const std::vector<float>& row) {
    float most = 0;
    for (const float v : row) most = std::max(most, std::abs(v));
    return most;
}

float largest_difference(const float* a, const float* b, std::size_t count) {
    float most = 0;
    for (std::size_t i = 0; i < count; ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

/// Between a cell and what lies beyond the side next to it; `across` is the cell at the opposite side.
float beyond_side(Side side, float cell, float across, bool normal) {
    if (side == Side::periodic) return std::abs(cell - across);
    return side == Side::wall && normal ? 2 * std::abs(cell) : 0;
}

Displacements within_row(const DisplacedRow& row, Side side) {
    Displacements d;
    d.largest = {largest_of(row.x), largest_of(row.y)};
    const std::size_t last = row.x.size() - 1;
    d.along_x = {largest_difference(row.x.data(), row.x.data() + 1, last),
                 largest_difference(row.y.data(), row.y.data() + 1, last)};
    for (const auto& [cell, across] : {std::pair{std::size_t{0}, last}, {last, std::size_t{0}}})
        d.along_x = glm::max(d.along_x, glm::vec2{beyond_side(side, row.x[cell], row.x[across], true),
                                                  beyond_side(side, row.y[cell], row.y[across], false)});
    return d;
}

Displacements between_rows(const DisplacedRow& a, const DisplacedRow& b) {
    Displacements d;
    d.along_y = {largest_difference(a.x.data(), b.x.data(), a.x.size()),
                 largest_difference(a.y.data(), b.y.data(), a.y.size())};
    return d;
}

/// Of the whole surface raised by `raise_m`.
Displacements displacements(const f32::FloorLight& light, const Surface& surface, float raise_m) {
    const int nx = surface.grid.nx, ny = surface.grid.ny;
    Displacements all;
#pragma omp parallel
    {
        Displacements mine;
        DisplacedRow row(nx), next(nx);
        int landed = -1;
#pragma omp for schedule(static)
        for (int j = 0; j < ny; ++j) {
            if (landed == j)
                std::swap(row, next);
            else
                row.land(light, surface, j, raise_m);
            mine.include(within_row(row, surface.boundary.x));
            landed = j + 1;
            if (landed == ny) continue;
            next.land(light, surface, landed, raise_m);
            mine.include(between_rows(row, next));
        }
#pragma omp critical
        all.include(mine);
    }
    DisplacedRow first(nx), last(nx);
    first.land(light, surface, 0, raise_m);
    last.land(light, surface, ny - 1, raise_m);
    for (int i = 0; i < nx; ++i)
        for (const auto& [cell, across] : {std::pair{&first, &last}, {&last, &first}})
            all.along_y =
                glm::max(all.along_y, glm::vec2{beyond_side(surface.boundary.y, cell->x[i], across->x[i], false),
                                                beyond_side(surface.boundary.y, cell->y[i], across->y[i], true)});
    return all;
}

/// Of the surface and, where it is tilted, of what lies beyond the domain: it goes on climbing as far as the window and
/// the sun's slant reach.
Displacements all_displacements(const f32::FloorLight& light, const Surface& surface) {
    Displacements all = displacements(light, surface, 0);
    const float slant_m = light.depth * (std::abs(light.rest_travel.x) + std::abs(light.rest_travel.y));
    for (int k = 0; k < 8 && surface.tilt != glm::dvec2{0, 0}; ++k) {
        const glm::vec2 margin_m = all.largest / glm::vec2{glm::length(light.pixel_x), glm::length(light.pixel_y)};
        const float climb = static_cast<float>(glm::length(surface.tilt)) * (margin_m.x + margin_m.y + slant_m);
        all.include(displacements(light, surface, climb));
        all.include(displacements(light, surface, -climb));
    }
    return all;
}

/// A bound of what any parallelogram spans to each side of its centre, from those of a - (1, 0) and b - (0, 1).
glm::vec2 largest_half_extent(glm::vec2 a, glm::vec2 b) {
    const float a_x = 1 + a.x, b_y = 1 + b.y;
    const bool b_climbs = 1 - b.y > a.y;
    const float slid = b_climbs ? a_x + 2 * b.x : std::max(a_x + 2 * b.x, b.x + 2 * a_x);
    return 0.5F * glm::vec2{slid, b_climbs ? b_y + a.y : 2 * std::max(a.y, b_y)};
}

}  // namespace

FloorWindow auto_window(const FloorFrame& frame, const FloorSettings& settings, const Surface& surface) {
    const Displacements d = all_displacements(frame.light, surface);
    glm::vec2 reach = d.largest;
    if (frame.adaptive) {
        constexpr float margin = 1.05F;  // for what happens between cells
        const FloorPlan& plan = settings.plan;
        const glm::vec2 cell{surface.grid.dx_m, surface.grid.dy_m};
        const auto per_step = [&](glm::dvec2 step_m) {
            const glm::vec2 cells = glm::abs(glm::vec2(step_m)) / cell;
            return margin * (cells.x * d.along_x + cells.y * d.along_y);
        };
        glm::vec2 a = per_step(plan.pitch_m.x * plan.axis_x()), b = per_step(plan.pitch_m.y * plan.axis_y());
        if (surface.boundary.x == Side::absorbing || surface.boundary.y == Side::absorbing) {
            a = glm::max(a, 0.5F * d.largest);
            b = glm::max(b, 0.5F * d.largest);
        }
        // No difference between samples is larger than that of the two farthest.
        reach += largest_half_extent(glm::min(a, d.largest), glm::min(b, d.largest)) - 0.5F;
    }
    // From here on floats cannot tell the places of neighbouring pixels apart.
    constexpr float farthest = 1 << 23;
    if (const float most = std::max(reach.x, reach.y); !(most < farthest))
        throw InputError(fmt::format(
            "floor map: light lands up to {:.3g} pixels from where it would below still water; allowed: less "
            "than 2^23. Give fewer, larger pixels, less depth or gentler waves",
            most));
    const auto size = [](float pixels) { return 2 * static_cast<int>(std::ceil(pixels)) + 1; };
    return {size(reach.x), size(reach.y)};
}

}  // namespace waterlight
