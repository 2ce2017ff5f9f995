// A triangle of the surface, cut by where its light goes.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "caustics/polygon.hpp"
#include "sim/boundary.hpp"
#include "sim/grid.hpp"

namespace waterlight {

/// A ray of light: from the surface to where it would land were there no walls.
struct WallRay {
    glm::dvec3 start{0, 0, 0};
    glm::dvec3 end{0, 0, 0};
};

/// Where a part of a triangle's light goes: the floor, or over one of the four sides of the domain.
enum class WayEnd { west, east, south, north, floor };

/// Cuts triangles into parts. A part is a polygon in the triangle's own coordinates (u, v), corners (0, 0), (1, 0) and
/// (0, 1); its share of the triangle is twice its area.
class WallSplit {
  public:
    WallSplit(const Grid& grid, Boundary boundary);

    /// Calls take(end, polygon) for each part. Together they are the whole triangle: nothing is counted twice, also
    /// where light leaves through a corner. Landing is linear over the triangle, and which of two sides is met first
    /// too.
    template <class Take>
    void split(const std::array<WallRay, 3>& rays, Take&& take) const {
        Polygon whole;
        for (const glm::dvec2 corner : {glm::dvec2{0, 0}, {1, 0}, {0, 1}}) whole.add(corner);
        const glm::ivec2 side = beyond(rays[0]);
        const bool alike = side == beyond(rays[1]) && side == beyond(rays[2]);
        if (alike) return give(rays, side, whole, take);
        const auto parts_x = cut(rays, whole, 0);
        for (int x = -1; x <= 1; ++x) {
            const Polygon& column = parts_x[static_cast<std::size_t>(x + 1)];
            if (column.count < 3) continue;
            const auto parts_y = cut(rays, column, 1);
            for (int y = -1; y <= 1; ++y) give(rays, {x, y}, parts_y[static_cast<std::size_t>(y + 1)], take);
        }
    }

    /// Whether all of the light ends on the floor; no ray ends beyond a side that does not repeat.
    bool stays(const WallRay& a, const WallRay& b, const WallRay& c) const {
        const glm::ivec2 inside{0, 0};
        return beyond(a) == inside && beyond(b) == inside && beyond(c) == inside;
    }
    /// The ray at (u, v) of the triangle.
    static WallRay ray_at(const std::array<WallRay, 3>& rays, glm::dvec2 uv);
    /// Part of a ray's way after which it meets this side.
    double part_of_way(const WallRay& ray, WayEnd end) const;

  private:
    /// For each axis -1 or 1 where a ray ends below or above the domain, 0 where within or where the domain repeats.
    glm::ivec2 beyond(const WallRay& ray) const {
        const auto along = [](bool wraps, double x, double low, double high) {
            return wraps ? 0 : int(x > high) - int(x < low);
        };
        return {along(wraps_.x, ray.end.x, low_.x, high_.x), along(wraps_.y, ray.end.y, low_.y, high_.y)};
    }
    /// What ends below, within and above the domain along an axis.
    std::array<Polygon, 3> cut(const std::array<WallRay, 3>& rays, const Polygon& polygon, int axis) const;
    /// Which is met first of the side in x and the side in y: positive where that in y is.
    double x_after_y(const WallRay& ray, glm::ivec2 side) const;

    template <class Take>
    void give(const std::array<WallRay, 3>& rays, glm::ivec2 side, const Polygon& polygon, Take&& take) const {
        if (polygon.count < 3) return;
        const WayEnd over_x = side.x < 0 ? WayEnd::west : WayEnd::east;
        const WayEnd over_y = side.y < 0 ? WayEnd::south : WayEnd::north;
        if (side.y == 0) return take(side.x == 0 ? WayEnd::floor : over_x, polygon);
        if (side.x == 0) return take(over_y, polygon);
        const auto later = [&](glm::dvec2 uv) { return x_after_y(ray_at(rays, uv), side); };
        const Polygon y_first = part_where(polygon, later, 1), x_first = part_where(polygon, later, -1);
        if (y_first.count >= 3) take(over_y, y_first);
        if (x_first.count >= 3) take(over_x, x_first);
    }

    /// The part of a polygon where sign * value >= 0, the value linear along its edges.
    template <class Value>
    static Polygon part_where(const Polygon& p, Value&& value, double sign) {
        Polygon kept;
        for (int i = 0; i < p.count; ++i) {
            const glm::dvec2 a = p.corner[i], b = p.corner[i + 1 == p.count ? 0 : i + 1];
            const double va = sign * value(a), vb = sign * value(b);
            if (va >= 0) kept.add(a);
            if ((va > 0 && vb < 0) || (va < 0 && vb > 0)) kept.add(a + va / (va - vb) * (b - a));
        }
        return kept;
    }

    glm::dvec2 low_, high_;
    glm::bvec2 wraps_;
};

}  // namespace waterlight
