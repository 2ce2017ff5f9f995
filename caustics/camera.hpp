// A pinhole camera.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace waterlight {

struct Camera;
Camera mirrored(const Camera& camera);

struct Camera {
    glm::dvec3 position_m{0, 0, -1};
    glm::dvec3 target_m{1, 0, -1};  ///< seen in the middle of the picture
    double fov_deg = 50;            ///< angle from the lower to the upper edge, in (0, 180)
    glm::ivec2 size{900, 600};      ///< pixels, >= 1
    bool mirrored = false;          ///< place, target and rays are those of mirrored(): the picture is the same
    bool operator==(const Camera&) const = default;

    /// Pixel (i, j), j counted upwards, looks along corner + i right + j up, which advances by 1 along the view.
    struct Rays {
        glm::dvec3 corner, right, up, forward;
        glm::dvec3 at(double i, double j) const { return corner + i * right + j * up; }
    };

    /// Pixel centres are at whole i and j. z is up in the picture; looking straight up or down, y is.
    Rays rays() const {
        if (mirrored) {
            const Rays r = waterlight::mirrored(*this).rays();
            return {flipped(r.corner), flipped(r.right), flipped(r.up), flipped(r.forward)};
        }
        const glm::dvec3 forward = glm::normalize(target_m - position_m);
        const bool level = std::abs(forward.z) < 1 - 1e-9;
        const glm::dvec3 right = glm::normalize(glm::cross(forward, level ? glm::dvec3{0, 0, 1} : glm::dvec3{0, 1, 0}));
        const glm::dvec3 up = glm::cross(right, forward);
        const double pixel = 2 * std::tan(fov_deg * std::numbers::pi / 360) / size.y;
        const glm::dvec2 middle = 0.5 * glm::dvec2(size - 1);
        return {forward - pixel * (middle.x * right + middle.y * up), pixel * right, pixel * up, forward};
    }

    static glm::dvec3 flipped(glm::dvec3 v) { return {v.x, v.y, -v.z}; }
};

/// The camera where heights are counted downwards, as of reflected beams: it sees there what `camera` sees in the
/// world.
inline Camera mirrored(const Camera& camera) {
    Camera other = camera;
    other.position_m = Camera::flipped(camera.position_m);
    other.target_m = Camera::flipped(camera.target_m);
    other.mirrored = !camera.mirrored;
    return other;
}

}  // namespace waterlight
