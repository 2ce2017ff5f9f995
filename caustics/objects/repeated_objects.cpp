#include "caustics/objects/repeated_objects.hpp"

#include <algorithm>
#include <cmath>

namespace waterlight {

namespace {

/// The part of a ray, from `near` to `far`, between two planes across an axis.
struct Part {
    double near, far;
    Part between(double from, double along, double low, double high) const {
        if (along == 0) return from >= low && from <= high ? *this : Part{1, 0};
        const double a = (low - from) / along, b = (high - from) / along;
        return {std::max(near, std::min(a, b)), std::min(far, std::max(a, b))};
    }
    bool empty() const { return !(near <= far); }
};

/// Whole periods by which [low, high] may be moved to meet [from, to].
struct Periods {
    int first = 0, last = 0;
    Periods(double period, double from, double to, double low, double high) {
        if (period == 0) return;
        first = static_cast<int>(std::ceil((from - high) / period));
        last = static_cast<int>(std::floor((to - low) / period));
    }
};

}  // namespace

RepeatedObjects::RepeatedObjects(std::shared_ptr<const ObjectSet> set, double time_s, const Grid& domain,
                                 Boundary boundary)
    : placed_(std::move(set), time_s) {
    if (boundary.x == Side::periodic) period_m_[0] = domain.width_m();
    if (boundary.y == Side::periodic) period_m_[1] = domain.height_m();
}

std::optional<ObjectHit> RepeatedObjects::first_hit(const Ray& ray) const {
    const glm::dvec3 low = placed_.low_m(), high = placed_.high_m();
    const auto [px, py] = period_m_;
    const glm::dvec3 from = ray.from_m, along = ray.direction;
    const Part level = Part{ray.nearest_m, ray.farthest_m}.between(from.z, along.z, low.z, high.z);
    if (level.empty()) return std::nullopt;
    std::optional<ObjectHit> nearest;
    const auto ends = [](double at, double speed, const Part& part) {
        const double a = at + part.near * speed, b = speed == 0 ? a : at + part.far * speed;
        return std::minmax({a, b});
    };
    const auto [west, east] = ends(from.x, along.x, level);
    const Periods columns(px, west, east, low.x, high.x);
    for (int p = columns.first; p <= columns.last; ++p) {
        const Part column = level.between(from.x - p * px, along.x, low.x, high.x);
        if (column.empty()) continue;
        const auto [south, north] = ends(from.y, along.y, column);
        const Periods rows(py, south, north, low.y, high.y);
        for (int q = rows.first; q <= rows.last; ++q) {
            if (column.between(from.y - q * py, along.y, low.y, high.y).empty()) continue;
            Ray moved = ray;
            moved.from_m -= glm::dvec3{p * px, q * py, 0};
            if (nearest) moved.farthest_m = nearest->distance_m;
            if (const auto hit = placed_.first_hit(moved)) nearest = hit;
        }
    }
    return nearest;
}

RepeatedObjects::Shifts RepeatedObjects::shifts(int object, glm::dvec2 low_m, glm::dvec2 high_m) const {
    const glm::dvec3 low = placed_.low_m(object), high = placed_.high_m(object);
    Shifts all;
    for (int axis = 0; axis < 2; ++axis) {
        const Periods p(period_m_[axis], low_m[axis], high_m[axis], low[axis], high[axis]);
        all.first[axis] = p.first;
        all.last[axis] = p.last;
        if (period_m_[axis] == 0 && (low_m[axis] > high[axis] || high_m[axis] < low[axis])) all.last[axis] = -1;
    }
    return all;
}

}  // namespace waterlight
