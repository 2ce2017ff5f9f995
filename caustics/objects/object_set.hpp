// Objects, and what a ray among them meets first. Embree finds it; the place itself is computed in double precision on
// the shape as it is: spheres, cones and rings are exact, not made of triangles.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "caustics/objects/object.hpp"

namespace waterlight {

/// from_m + t direction, t in metres; the direction is a unit vector.
struct Ray {
    glm::dvec3 from_m{0, 0, 0};
    glm::dvec3 direction{0, 0, -1};
    /// What is nearer than this is not met: light that leaves a surface does not meet it again at once.
    double nearest_m = 1e-7;
    double farthest_m = std::numeric_limits<double>::infinity();

    glm::dvec3 at(double t) const { return from_m + t * direction; }
};

/// Where a ray meets an object.
struct ObjectHit {
    double distance_m = 0;
    glm::dvec3 normal{0, 0, 1};  ///< unit, out of the object
    int object = 0;              ///< its number in the set
    /// Whether the ray comes from outside.
    bool enters(const Ray& ray) const { return glm::dot(ray.direction, normal) < 0; }
};

/// Objects at all times. Cheap to share; never changes.
class ObjectSet {
  public:
    /// Throws InputError as validate() does, WorldError where Embree fails.
    explicit ObjectSet(std::vector<Object> objects);
    ~ObjectSet();
    ObjectSet(const ObjectSet&) = delete;
    ObjectSet& operator=(const ObjectSet&) = delete;

    const std::vector<Object>& objects() const { return objects_; }
    bool empty() const { return objects_.empty(); }
    /// Whether any has a path.
    bool moves() const;

  private:
    friend class PlacedObjects;
    struct Shapes;
    std::vector<Object> objects_;
    std::unique_ptr<Shapes> shapes_;
};

/// The objects at one time.
class PlacedObjects {
  public:
    PlacedObjects(std::shared_ptr<const ObjectSet> set, double time_s);
    ~PlacedObjects();
    PlacedObjects(PlacedObjects&&) noexcept;

    const Object& object(int number) const { return set_->objects()[static_cast<std::size_t>(number)]; }
    /// The first that the ray meets between nearest_m and farthest_m. Any number of threads at once.
    std::optional<ObjectHit> first_hit(const Ray& ray) const;
    /// Whether there is none between two places, apart from what is within a ten-millionth of a metre of either.
    bool clear(glm::dvec3 from_m, glm::dvec3 to_m) const;
    /// The box that holds them all; low > high where there are none.
    glm::dvec3 low_m() const { return low_m_; }
    glm::dvec3 high_m() const { return high_m_; }
    int count() const { return set_ ? static_cast<int>(set_->objects().size()) : 0; }
    /// The box that holds one of them.
    glm::dvec3 low_m(int number) const;
    glm::dvec3 high_m(int number) const;

  private:
    struct Top;
    std::shared_ptr<const ObjectSet> set_;
    std::unique_ptr<Top> top_;
    glm::dvec3 low_m_{1, 1, 1}, high_m_{-1, -1, -1};
};

}  // namespace waterlight
