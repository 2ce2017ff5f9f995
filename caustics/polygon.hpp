// Area of the part of a triangle that lies in each pixel of a grid, exactly, by clipping to columns and then to rows.
#pragma once

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace waterlight {

/// A convex polygon of at most 8 corners: a triangle cut by up to four lines has seven.
struct Polygon {
    std::array<glm::dvec2, 8> corner;
    int count = 0;
    void add(glm::dvec2 p) { corner[count++] = p; }
};

/// Signed area, from corners relative to the first so that small polygons far from the origin keep their digits.
inline double area(const Polygon& p) {
    double twice = 0;
    for (int i = 1; i + 1 < p.count; ++i) {
        const glm::dvec2 a = p.corner[i] - p.corner[0], b = p.corner[i + 1] - p.corner[0];
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * twice;
}

/// The part of `p` where sign * (coordinate `axis`) >= sign * at.
inline Polygon clip(const Polygon& p, int axis, double at, double sign) {
    Polygon kept;
    for (int i = 0; i < p.count; ++i) {
        const glm::dvec2 a = p.corner[i], b = p.corner[i + 1 == p.count ? 0 : i + 1];
        const double da = sign * (a[axis] - at), db = sign * (b[axis] - at);
        if (da >= 0) kept.add(a);
        if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
            glm::dvec2 cut = a + da / (da - db) * (b - a);
            cut[axis] = at;
            kept.add(cut);
        }
    }
    return kept;
}

/// Calls take(column, row, area) for every pixel that triangle abc overlaps, with columns and rows limited to
/// [low, high); pixel (i, j) is [i, i + 1) x [j, j + 1). Areas are absolute.
template <class Take>
void rasterise(const std::array<glm::dvec2, 3>& t, glm::ivec2 low, glm::ivec2 high, Take&& take) {
    Polygon whole;
    glm::dvec2 least = t[0], most = t[0];
    for (const glm::dvec2& p : t) {
        whole.add(p);
        least = glm::min(least, p);
        most = glm::max(most, p);
    }
    const auto first = [](double x, int lowest) {
        return std::max(lowest, static_cast<int>(std::floor(std::max(x, -2e9))));
    };
    const auto last = [](double x, int highest) {
        return std::min(highest - 1, static_cast<int>(std::floor(std::min(x, 2e9))));
    };
    const int i0 = first(least.x, low.x), i1 = last(most.x, high.x);
    const int j0 = first(least.y, low.y), j1 = last(most.y, high.y);
    for (int i = i0; i <= i1; ++i) {
        Polygon column = i == static_cast<int>(std::floor(least.x)) ? whole : clip(whole, 0, i, 1);
        if (most.x > i + 1) column = clip(column, 0, i + 1, -1);
        for (int j = j0; j <= j1; ++j) {
            Polygon cell = j == static_cast<int>(std::floor(least.y)) ? column : clip(column, 1, j, 1);
            if (most.y > j + 1) cell = clip(cell, 1, j + 1, -1);
            const double overlap = std::abs(area(cell));
            if (overlap > 0) take(i, j, overlap);
        }
    }
}

}  // namespace waterlight
