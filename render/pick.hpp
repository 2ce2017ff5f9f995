// What lies under a pixel of a picture.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "caustics/camera.hpp"
#include "sim/surface.hpp"

namespace waterlight {

/// Where the ray of a pixel first meets the water, from above or from below; none where it does not within the grid.
/// The elevation is bilinear between the centres of cells and goes on as a plane over the last half cell. `pixel` is as
/// Camera::Rays::at() takes it and may have parts of one. Exact on a plane; elsewhere to a millionth of a cell along
/// the ray, but a crest thinner than a quarter of a cell may be missed.
std::optional<glm::dvec3> pick_water(const Surface& surface, const Camera& camera, glm::dvec2 pixel);

/// Where that ray meets the height z = `z_m` ahead of the camera.
std::optional<glm::dvec3> pick_level(double z_m, const Camera& camera, glm::dvec2 pixel);

}  // namespace waterlight
