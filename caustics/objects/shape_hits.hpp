// Where a ray meets a shape, in double precision, on the shape as it is.
#pragma once

#include <span>
#include <vector>

#include "caustics/objects/object_set.hpp"

namespace waterlight {

/// The nearest meeting so far.
struct NearestHit {
    double distance_m;           ///< at first the ray's farthest_m
    glm::dvec3 normal{0, 0, 1};  ///< out of the shape
    bool met = false;

    void offer(double t, const Ray& ray, glm::dvec3 outwards) {
        if (!(t > ray.nearest_m && t < distance_m)) return;
        distance_m = t;
        normal = outwards;
        met = true;
    }
};

/// An edge of a profile in the half-plane of radius (x) and height (y); turned about the axis, a part of a cone, a
/// cylinder or a flat ring. The shape is on its left.
struct ProfileEdge {
    glm::dvec2 from_m{0, 0}, to_m{0, 0};
};

/// The profile of a shape of revolution; none for others.
std::vector<ProfileEdge> profile_of(const Shape& shape);

void meet(const Sphere& sphere, const Ray& ray, NearestHit& nearest);
void meet(const Box& box, const Ray& ray, NearestHit& nearest);
void meet(std::span<const ProfileEdge> profile, const Ray& ray, NearestHit& nearest);

/// Half of the box about the shape's own axes that holds it, and its middle.
struct ShapeBox {
    glm::dvec3 middle_m{0, 0, 0}, half_m{0, 0, 0};
};
ShapeBox box_of(const Shape& shape);

}  // namespace waterlight
