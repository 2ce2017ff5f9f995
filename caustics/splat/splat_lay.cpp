#include <algorithm>
#include <cmath>

#include "caustics/splat/splat_spread.hpp"

namespace waterlight {

namespace {

constexpr int lanes = 8;
using Lanes = std::array<float, lanes>;

/// Cells [first, end) of one axis.
struct CellSpan {
    int first = 0, end = 0;
};

CellSpan cells_within(float middle, float half, CellSpan limits) {
    const auto cell = [](float x) { return static_cast<int>(std::floor(std::clamp(x, -1e9F, 1e9F))); };
    return {std::max(limits.first, cell(middle - half)), std::min(limits.end, cell(middle + half) + 1)};
}

/// Adds a line of a splat to cells `stride` apart; returns how much it adds.
float add_line(float middle, float deviation, float power, CellSpan limits, float* to, std::ptrdiff_t stride) {
    const CellSpan cells = cells_within(middle, f32::splat_reach * deviation, limits);
    const float per = 1 / deviation;
    float laid = 0;
    for (int begin = cells.first; begin < cells.end; begin += lanes - 1) {
        Lanes below;
        const float from = static_cast<float>(begin) - middle;
        for (int k = 0; k < lanes; ++k) below[k] = power * f32::splat_below((from + static_cast<float>(k)) * per);
        const int count = std::min(lanes - 1, cells.end - begin);
        for (int k = 0; k < count; ++k) to[(begin + k) * stride] += below[k + 1] - below[k];
        laid += below[count] - below[0];
    }
    return laid;
}

/// The lines of a splat between `lanes` places one pixel apart.
struct Lines {
    Lanes place, density, below;

    Lines(float from, float per) {
        for (int k = 0; k < lanes; ++k) {
            place[k] = std::clamp((from + static_cast<float>(k)) * per, -f32::splat_reach, f32::splat_reach);
            const f32::NormalAt n = f32::normal_at(place[k]);
            density[k] = n.density;
            below[k] = n.below;
        }
    }
    f32::SplatLine line(const f32::SplatShape& shape, int k) const {
        return f32::splat_line(shape, place[k], {density[k], below[k]}, place[k + 1], {density[k + 1], below[k + 1]});
    }
};

/// Adds a splat about `at` to a part of the map. Returns how much of its light lies there, W.
float add_gaussian(const f32::SplatShape& s, glm::dvec2 at, float power, MapPart& part) {
    const int width = part.power_w.nx();
    // About the cell of the centre, so that floats hold the rest.
    const glm::dvec2 cell = glm::floor(at);
    const glm::vec2 centre(at - cell);
    const glm::ivec2 base = glm::ivec2(cell) - part.first;
    const CellSpan columns{-base.x, width - base.x}, rows{-base.y, part.power_w.ny() - base.y};
    float* origin = part.power_w.data() + (static_cast<std::ptrdiff_t>(base.y) * width + base.x);
    const bool upright = s.transposed != 0;
    const float major = upright ? centre.y : centre.x, minor = upright ? centre.x : centre.y;
    const CellSpan across = upright ? columns : rows;
    const std::ptrdiff_t major_stride = upright ? width : 1, minor_stride = upright ? 1 : width;
    const CellSpan cells = cells_within(major, f32::splat_reach * s.along, upright ? rows : columns);
    const float per = 1 / s.along;
    float laid = 0;
    for (int begin = cells.first; begin < cells.end; begin += lanes - 1) {
        const Lines lines(static_cast<float>(begin) - major, per);
        const int count = std::min(lanes - 1, cells.end - begin);
        for (int k = 0; k < count; ++k) {
            const f32::SplatLine line = lines.line(s, k);
            laid += add_line(minor + line.middle, line.deviation, power * line.share, across,
                             origin + (begin + k) * major_stride, minor_stride);
        }
    }
    return laid;
}

/// A splat near an edge of the lattice: what lies beyond is mirrored.
float add_edged(const Splat& splat, MapPart& part) {
    const glm::dvec2 reach = splat.reach();
    const glm::ivec2 low(glm::floor(splat.centre - reach)), high(glm::floor(splat.centre + reach));
    if (high.x - low.x >= f32::widest_edged || high.y - low.y >= f32::widest_edged)
        return add_gaussian(splat.shape, splat.centre, splat.power_w, part);
    MapPart tile{low, Field<float>(high.x - low.x + 1, high.y - low.y + 1)};
    const auto& [x, y] = splat.edges;
    const auto is = [](const f32::SplatEdge& e) { return e.normal != glm::vec2{0, 0}; };
    const auto add = [&](glm::vec2 by) {
        add_gaussian(splat.shape, splat.centre + glm::dvec2(by), splat.power_w, tile);
    };
    add({0, 0});
    if (is(x)) add(x.mirrored);
    if (is(y)) add(y.mirrored);
    if (is(x) && is(y)) add(x.mirrored + y.mirrored);
    double sum = 0;
    for (int j = 0; j < tile.power_w.ny(); ++j)
        for (int i = 0; i < tile.power_w.nx(); ++i) {
            const glm::vec2 middle(glm::dvec2(low) + glm::dvec2(i + 0.5, j + 0.5) - splat.centre);
            tile.power_w(i, j) *= f32::inside_edge(x, middle) * f32::inside_edge(y, middle);
            sum += tile.power_w(i, j);
        }
    if (!(sum > 0)) return add_gaussian(splat.shape, splat.centre, splat.power_w, part);
    const float scale = splat.power_w / static_cast<float>(sum);
    float laid = 0;
    for (int j = std::max(low.y, part.first.y); j <= std::min(high.y, part.first.y + part.power_w.ny() - 1); ++j)
        for (int i = std::max(low.x, part.first.x); i <= std::min(high.x, part.first.x + part.power_w.nx() - 1); ++i) {
            const float power = scale * tile.power_w(i - low.x, j - low.y);
            part.power_w(i - part.first.x, j - part.first.y) += power;
            laid += power;
        }
    return laid;
}

}  // namespace

float add_splat(const Splat& splat, MapPart& part) {
    return splat.near_edge ? add_edged(splat, part) : add_gaussian(splat.shape, splat.centre, splat.power_w, part);
}

}  // namespace waterlight
