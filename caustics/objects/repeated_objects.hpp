// Objects as light of a periodic domain meets them: repeated beyond its periodic sides.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "caustics/objects/object_set.hpp"
#include "sim/boundary.hpp"
#include "sim/grid.hpp"

namespace waterlight {

class RepeatedObjects {
  public:
    RepeatedObjects(std::shared_ptr<const ObjectSet> set, double time_s, const Grid& domain, Boundary boundary);

    /// The first that the ray meets, wherever it is repeated. The ray's farthest_m is finite where it is level. Any
    /// number of threads at once.
    std::optional<ObjectHit> first_hit(const Ray& ray) const;
    /// Whether the box of an object, or of one of its repetitions, meets a box that is as wide and deep as these
    /// corners say; heights do not count.
    bool over(int object, glm::dvec2 low_m, glm::dvec2 high_m) const;
    const PlacedObjects& placed() const { return placed_; }

  private:
    PlacedObjects placed_;
    std::array<double, 2> period_m_{0, 0};  ///< 0 along an axis that does not repeat
};

}  // namespace waterlight
