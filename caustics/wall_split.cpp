#include "caustics/wall_split.hpp"

#include <glm/common.hpp>

#include "caustics/kernels/walls.hpp"

namespace waterlight {

WallSplit::WallSplit(const Grid& grid, Boundary boundary)
    : low_(grid.x0_m, grid.y0_m),
      high_(low_ + glm::dvec2{grid.width_m(), grid.height_m()}),
      wraps_(boundary.x == Side::periodic, boundary.y == Side::periodic) {}

WallRay WallSplit::ray_at(const std::array<WallRay, 3>& rays, glm::dvec2 uv) {
    const auto between = [&](glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) { return a + uv.x * (b - a) + uv.y * (c - a); };
    return {between(rays[0].start, rays[1].start, rays[2].start), between(rays[0].end, rays[1].end, rays[2].end)};
}

double WallSplit::part_of_way(const WallRay& ray, WayEnd end) const {
    if (end == WayEnd::floor) return 1;
    const int axis = end == WayEnd::west || end == WayEnd::east ? 0 : 1;
    return f64::part_inside(ray.start[axis], ray.end[axis], low_[axis], high_[axis]);
}

std::array<Polygon, 3> WallSplit::cut(const std::array<WallRay, 3>& rays, const Polygon& polygon, int axis) const {
    if (wraps_[axis]) return {Polygon{}, polygon, Polygon{}};
    const auto over_low = [&](glm::dvec2 uv) { return ray_at(rays, uv).end[axis] - low_[axis]; };
    const auto over_high = [&](glm::dvec2 uv) { return ray_at(rays, uv).end[axis] - high_[axis]; };
    return {part_where(polygon, over_low, -1), part_where(part_where(polygon, over_low, 1), over_high, -1),
            part_where(polygon, over_high, 1)};
}

double WallSplit::x_after_y(const WallRay& ray, glm::ivec2 side) const {
    const glm::dvec2 wall{side.x < 0 ? low_.x : high_.x, side.y < 0 ? low_.y : high_.y};
    const glm::dvec2 left = glm::abs(wall - glm::dvec2(ray.start)), way = glm::abs(glm::dvec2(ray.end - ray.start));
    return left.x * way.y - left.y * way.x;
}

}  // namespace waterlight
