// What disturbs the water at a moment that nobody knew before: a hand. Like a source, it makes and takes no water.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <variant>

#include "sim/sources.hpp"

namespace waterlight {

/// The elevation gains volume / (pi R^2) exp(-r^2/R^2): water pushed up by a body that takes its place. All of the
/// water sinks by as much as keeps its volume.
struct Push {
    glm::dvec2 at_m{0, 0};
    double radius_m = 0.25;  ///< R > 0
    double volume_m3 = 0;    ///< negative lets it down
};

/// A drop's time_s counts for nothing here.
using Disturbance = std::variant<Drop, Push>;

/// Throws InputError where a number of it is out of its range.
void require_valid(const Disturbance& disturbance);

/// What a disturbance adds to the cells of a grid, its images beyond the sides included; the sum is zero. That of a
/// push covers the grid.
DropPatch patch_of(const Disturbance& disturbance, const Grid& grid, Boundary boundary);

/// Volume (m3) of the part of a sphere that is below z = 0.
double submerged_volume_m3(double centre_z_m, double radius_m);

/// What a sphere does that moves between two centres. Where a column of water of elevation eta holds a body of
/// thickness s, continuity is d(eta - s)/dt + div q = 0: over a move that is fast against the waves the elevation gains
/// where the body comes to, and loses where it was, what the body takes of the column. That is smoothed to a Gaussian
/// of the sphere's radius and of the volume below still water. (webgl-water by E. Wallace does so with the opposite
/// sign.)
std::array<Push, 2> sphere_pushes(glm::dvec3 from_m, glm::dvec3 to_m, double radius_m);

}  // namespace waterlight
