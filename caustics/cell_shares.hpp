// Exact shares of a polygon in the cells of a grid, by signed area under its edges, as font rasterisers do it.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace waterlight {

/// Holds its buffer between polygons; one thread at a time.
class CellShares {
  public:
    /// Calls take(column, row, share) for the cells that the polygon overlaps; cell (i, j) is [i, i + 1) x [j, j + 1),
    /// shares are fractions of the polygon's area and add up to 1. A polygon without area goes to the cell of its
    /// middle. Corners in order either way round; convex, finite, below 1e9 from the origin.
    template <class Take>
    void share(std::span<const glm::dvec2> corners, Take&& take) {
        glm::dvec2 low = corners[0], high = corners[0], sum{0, 0};
        for (const glm::dvec2& p : corners) {
            low = glm::min(low, p);
            high = glm::max(high, p);
            sum += p;
        }
        const glm::dvec2 base = glm::floor(low);
        const glm::ivec2 first(base), last(glm::floor(high));
        if (first == last) return take(first.x, first.y, 1.0);
        width_ = last.x - first.x + 2;
        const int rows = last.y - first.y + 1;
        cover_.assign(static_cast<std::size_t>(width_) * rows, 0.0);
        double twice = 0;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const glm::dvec2 a = corners[k] - base, b = corners[k + 1 == corners.size() ? 0 : k + 1] - base;
            twice += a.x * b.y - a.y * b.x;
            add_edge(a, b);
        }
        constexpr double line = 1e-12;  // below which shares would be rounding
        if (std::abs(twice) < line) {
            const glm::dvec2 middle = glm::floor(sum / static_cast<double>(corners.size()));
            return take(static_cast<int>(middle.x), static_cast<int>(middle.y), 1.0);
        }
        const double scale = -2 / twice;
        for (int j = 0; j < rows; ++j) {
            const double* row = cover_.data() + static_cast<std::ptrdiff_t>(j) * width_;
            double covered = 0;
            for (int i = 0; i + 1 < width_; ++i) {
                covered += row[i];
                const double part = scale * covered;
                if (part > 0) take(first.x + i, first.y + j, part);
            }
        }
    }

  private:
    /// Adds, signed by the edge's direction up, the area to the right of edge ab: to each cell its own part, and to the
    /// next the rest, so that the sum along a row up to a cell is that cell's.
    void add_edge(glm::dvec2 a, glm::dvec2 b) {
        if (a.y == b.y) return;
        const double sign = a.y < b.y ? 1 : -1;
        if (a.y > b.y) std::swap(a, b);
        const double lean = (b.x - a.x) / (b.y - a.y);
        double y = a.y, x = a.x;
        for (int j = static_cast<int>(a.y); y < b.y; ++j) {
            const bool ends = b.y <= j + 1;
            const double next_y = ends ? b.y : j + 1, next_x = ends ? b.x : a.x + lean * (next_y - a.y);
            add_in_row(cover_.data() + static_cast<std::ptrdiff_t>(j) * width_, x, next_x, sign * (next_y - y));
            y = next_y;
            x = next_x;
        }
    }

    void add_in_row(double* row, double x0, double x1, double rise) const {
        if (x0 > x1) std::swap(x0, x1);
        x0 = std::max(x0, 0.0);
        int i = static_cast<int>(x0);
        const int last = std::min(static_cast<int>(x1), width_ - 2);
        if (i >= last) {
            const double part = rise * (0.5 * (x0 + x1) - i);
            row[i] += rise - part;
            row[i + 1] += part;
            return;
        }
        const double per_x = rise / (x1 - x0);
        for (double x = x0; i <= last; ++i) {
            const double next = i == last ? x1 : i + 1, part = per_x * (next - x), right = 0.5 * (x + next) - i;
            row[i] += part * (1 - right);
            row[i + 1] += part * right;
            x = next;
        }
    }

    int width_ = 0;
    std::vector<double> cover_;
};

}  // namespace waterlight
