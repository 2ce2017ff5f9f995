#include "caustics/objects/shape_hits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace waterlight {

namespace {

/// Calls take(t) for the real roots of a t^2 + 2 b t + c, without cancellation.
template <class Take>
void roots(double a, double b, double c, Take&& take) {
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0)) return;
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    if (a != 0) take(q / a);
    if (q != 0) take(c / q);
}

void meet(const ProfileEdge& edge, const Ray& ray, NearestHit& nearest) {
    const glm::dvec3 o = ray.from_m, d = ray.direction;
    const double rise = edge.to_m.y - edge.from_m.y, widening = edge.to_m.x - edge.from_m.x;
    const glm::dvec2 out = glm::normalize(glm::dvec2{rise, -widening});
    if (rise == 0) {
        if (d.z == 0) return;
        const double t = (edge.from_m.y - o.z) / d.z;
        const double radius = glm::length(glm::dvec2(ray.at(t)));
        if ((radius - edge.from_m.x) * (radius - edge.to_m.x) <= 0) nearest.offer(t, ray, {0, 0, out.y});
        return;
    }
    // On the cone x^2 + y^2 = r(z)^2 with r(z) = r0 + k (z - z0).
    const double k = widening / rise, r0 = edge.from_m.x + k * (o.z - edge.from_m.y);
    const double a = d.x * d.x + d.y * d.y - k * k * d.z * d.z, b = o.x * d.x + o.y * d.y - k * d.z * r0,
                 c = o.x * o.x + o.y * o.y - r0 * r0;
    const double low = std::min(edge.from_m.y, edge.to_m.y), high = std::max(edge.from_m.y, edge.to_m.y);
    roots(a, b, c, [&](double t) {
        const glm::dvec3 p = ray.at(t);
        const double radius = r0 + k * t * d.z;
        if (p.z < low || p.z > high || radius <= 0) return;
        nearest.offer(t, ray, {out.x * p.x / radius, out.x * p.y / radius, out.y});
    });
}

std::vector<ProfileEdge> edges_of(std::span<const glm::dvec2> corners) {
    std::vector<ProfileEdge> edges;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const glm::dvec2 a = corners[k], b = corners[(k + 1) % corners.size()];
        if (a.x > 0 || b.x > 0) edges.push_back({a, b});  // not along the axis
    }
    return edges;
}

}  // namespace

std::vector<ProfileEdge> profile_of(const Shape& shape) {
    if (const auto* ring = std::get_if<Ring>(&shape)) {
        const double half = 0.5 * ring->height_m, in = ring->inner_radius_m, out = ring->outer_radius_m;
        return edges_of(std::array<glm::dvec2, 4>{{{in, -half}, {out, -half}, {out, half}, {in, half}}});
    }
    if (const auto* cup = std::get_if<Cup>(&shape)) {
        // From the middle of the base outwards, up, over the rim, down inside.
        const double top = cup->height_m, bottom = cup->bottom_radius_m, wide = cup->top_radius_m;
        const double at_base = bottom + (wide - bottom) * cup->base_m / top - cup->wall_m;
        return edges_of(std::array<glm::dvec2, 6>{
            {{0, 0}, {bottom, 0}, {wide, top}, {wide - cup->wall_m, top}, {at_base, cup->base_m}, {0, cup->base_m}}});
    }
    return {};
}

void meet(const Sphere& sphere, const Ray& ray, NearestHit& nearest) {
    const double b = glm::dot(ray.from_m, ray.direction);
    const double c = glm::dot(ray.from_m, ray.from_m) - sphere.radius_m * sphere.radius_m;
    roots(1, b, c, [&](double t) { nearest.offer(t, ray, ray.at(t) / sphere.radius_m); });
}

void meet(const Box& box, const Ray& ray, NearestHit& nearest) {
    const glm::dvec3 half = 0.5 * box.size_m;
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0) continue;
        for (const double side : {-1.0, 1.0}) {
            const double t = (side * half[axis] - ray.from_m[axis]) / ray.direction[axis];
            const glm::dvec3 p = ray.at(t);
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            if (std::abs(p[u]) > half[u] || std::abs(p[v]) > half[v]) continue;
            glm::dvec3 out{0, 0, 0};
            out[axis] = side;
            nearest.offer(t, ray, out);
        }
    }
}

void meet(std::span<const ProfileEdge> profile, const Ray& ray, NearestHit& nearest) {
    for (const ProfileEdge& edge : profile) meet(edge, ray, nearest);
}

ShapeBox box_of(const Shape& shape) {
    struct Of {
        ShapeBox operator()(const Sphere& s) const { return {{0, 0, 0}, glm::dvec3(s.radius_m)}; }
        ShapeBox operator()(const Box& s) const { return {{0, 0, 0}, 0.5 * s.size_m}; }
        ShapeBox operator()(const Ring& s) const {
            return {{0, 0, 0}, {s.outer_radius_m, s.outer_radius_m, 0.5 * s.height_m}};
        }
        ShapeBox operator()(const Cup& s) const {
            const double radius = std::max(s.bottom_radius_m, s.top_radius_m), half = 0.5 * s.height_m;
            return {{0, 0, half}, {radius, radius, half}};
        }
        ShapeBox operator()(const Mesh& s) const {
            glm::dvec3 low = s.corners_m.front(), high = low;
            for (const glm::dvec3& p : s.corners_m) {
                low = glm::min(low, p);
                high = glm::max(high, p);
            }
            return {0.5 * (low + high), 0.5 * (high - low)};
        }
    };
    return std::visit(Of{}, shape);
}

}  // namespace waterlight
