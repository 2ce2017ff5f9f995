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
    /// The first and the last whole periods, along x and y, by which an object may be moved for its box to meet one
    /// that is as wide and deep as these corners say; heights do not count. first > last where there are none.
    struct Shifts {
        glm::ivec2 first{0, 0}, last{0, 0};
    };
    Shifts shifts(int object, glm::dvec2 low_m, glm::dvec2 high_m) const;
    glm::dvec2 period_m() const { return {period_m_[0], period_m_[1]}; }
    const PlacedObjects& placed() const { return placed_; }

  private:
    PlacedObjects placed_;
    std::array<double, 2> period_m_{0, 0};  ///< 0 along an axis that does not repeat
};

}  // namespace waterlight
