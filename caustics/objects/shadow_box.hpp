// The shadow that the box about an object's own axes casts on a level plane: a hexagon that holds the object's.
#pragma once

#include <array>
#include <glm/vec2.hpp>

#include "caustics/objects/object.hpp"

namespace waterlight {

struct ShadowBox {
    glm::dvec3 middle_m{0, 0, 0};
    std::array<glm::dvec3, 3> half_m{};  ///< from the middle to the middles of three sides

    ShadowBox(const Object& object, double time_s);

    /// The least width of the shadow that light casts which goes `lean` metres aside for each metre up.
    double least_width_m(glm::dvec2 lean) const;
    /// Whether the shadow, moved by `shift_m`, meets a triangle or comes within `margin_m` of it; both on the plane at
    /// the box's middle.
    bool meets(const std::array<glm::dvec2, 3>& triangle, glm::dvec2 lean, glm::dvec2 shift_m, double margin_m) const;

  private:
    std::array<glm::dvec2, 3> half_shadow(glm::dvec2 lean) const;
};

}  // namespace waterlight
