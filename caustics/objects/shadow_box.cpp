#include "caustics/objects/shadow_box.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "caustics/objects/shape_hits.hpp"

namespace waterlight {

namespace {

/// Half of the hexagon's width across a direction.
double half_width(const std::array<glm::dvec2, 3>& half, glm::dvec2 across) {
    double width = 0;
    for (const glm::dvec2 h : half) width += std::abs(glm::dot(h, across));
    return width;
}

}  // namespace

ShadowBox::ShadowBox(const Object& object, double time_s) {
    const ShapeBox box = box_of(object.shape);
    const glm::dmat3 turn = object.turn();
    middle_m = object.centre_at(time_s) + turn * box.middle_m;
    for (int k = 0; k < 3; ++k) half_m[k] = box.half_m[k] * turn[k];
}

std::array<glm::dvec2, 3> ShadowBox::half_shadow(glm::dvec2 lean) const {
    std::array<glm::dvec2, 3> half;
    for (int k = 0; k < 3; ++k) half[k] = glm::dvec2(half_m[k]) - half_m[k].z * lean;
    return half;
}

double ShadowBox::least_width_m(glm::dvec2 lean) const {
    const std::array<glm::dvec2, 3> half = half_shadow(lean);
    double least = std::numeric_limits<double>::infinity();
    for (const glm::dvec2 side : half) {
        const double length = glm::length(side);
        if (!(length > 0)) continue;
        const double width = 2 * half_width(half, glm::dvec2{-side.y, side.x} / length);
        if (width > 0) least = std::min(least, width);
    }
    return least;
}

bool ShadowBox::meets(const std::array<glm::dvec2, 3>& triangle, glm::dvec2 lean, glm::dvec2 shift_m,
                      double margin_m) const {
    const std::array<glm::dvec2, 3> half = half_shadow(lean);
    const glm::dvec2 middle = glm::dvec2(middle_m) + shift_m;
    // Convex figures that do not meet are parted by a line along a side of one of them.
    const auto parted = [&](glm::dvec2 along) {
        const glm::dvec2 across{-along.y, along.x};
        const double a = glm::dot(triangle[0] - middle, across), b = glm::dot(triangle[1] - middle, across),
                     c = glm::dot(triangle[2] - middle, across);
        const double reach = half_width(half, across) + margin_m * glm::length(along);
        return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
    };
    return std::ranges::none_of(half, parted) && !parted(triangle[1] - triangle[0]) &&
           !parted(triangle[2] - triangle[1]) && !parted(triangle[0] - triangle[2]);
}

}  // namespace waterlight
