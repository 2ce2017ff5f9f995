// Light that does not come from the sun.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <variant>

#include "caustics/light.hpp"

namespace waterlight {

/// A point that sends light to all sides, or within a cone.
struct Lamp {
    enum class Type { point, spot };
    Type type = Type::point;
    glm::dvec3 at_m{0, 0, 5};       ///< z above still water
    double intensity_w_sr = 1000;   ///< >= 0; of a spot within its cone
    glm::dvec3 towards_m{0, 0, 0};  ///< of a spot: a place on its axis, not `at_m`
    double half_angle_deg = 30;     ///< of a spot: of its cone, in (0, 90); its edge is sharp

    /// Solid angle that it lights, sr.
    double solid_angle_sr() const {
        constexpr double radian = std::numbers::pi / 180, all = 4 * std::numbers::pi;
        return type == Type::point ? all : 2 * std::numbers::pi * (1 - std::cos(half_angle_deg * radian));
    }
    double power_w() const { return intensity_w_sr * solid_angle_sr(); }
    /// Whether light leaves it along this unit direction.
    bool lights(glm::dvec3 direction) const {
        constexpr double radian = std::numbers::pi / 180;
        return type == Type::point ||
               glm::dot(direction, glm::normalize(towards_m - at_m)) >= std::cos(half_angle_deg * radian);
    }
};

using LightSource = std::variant<Sun, Lamp>;

}  // namespace waterlight
