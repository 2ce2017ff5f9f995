#include "render/orbit_camera.hpp"

#include <algorithm>
#include <cassert>
#include <glm/trigonometric.hpp>

namespace waterlight {

namespace {

constexpr double farthest_m = 1e6;

/// A direction and a length in place of a vector.
struct Polar {
    double azimuth_deg, elevation_deg, length;

    glm::dvec3 vector() const {
        const double azimuth = glm::radians(azimuth_deg), elevation = glm::radians(elevation_deg);
        return length * glm::dvec3(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                                   std::sin(elevation));
    }
};

// A view straight up or down has no azimuth; that of Camera::rays() there, in which y is up in the picture, is north.
Polar polar(glm::dvec3 forward) {
    const double level = std::hypot(forward.x, forward.y), length = glm::length(forward);
    const double north = forward.z < 0 ? 90 : -90;
    const bool vertical = level < 1e-9 * length;
    return {vertical ? north : glm::degrees(std::atan2(forward.y, forward.x)),
            glm::degrees(std::atan2(forward.z, level)), length};
}

glm::dvec3 turned(glm::dvec3 forward, double azimuth_deg, double elevation_deg) {
    Polar p = polar(forward);
    p.azimuth_deg += azimuth_deg;
    p.elevation_deg = std::clamp(p.elevation_deg + elevation_deg, pole_gap_deg - 90, 90 - pole_gap_deg);
    return p.vector();
}

Camera shifted(Camera camera, glm::dvec3 by_m) {
    camera.position_m += by_m;
    camera.target_m += by_m;
    return camera;
}

}  // namespace

Camera orbited(const Camera& camera, double azimuth_deg, double elevation_deg) {
    assert(!camera.mirrored);
    Camera next = camera;
    next.position_m = camera.target_m - turned(camera.target_m - camera.position_m, azimuth_deg, -elevation_deg);
    return next;
}

Camera panned(const Camera& camera, glm::dvec2 pixels) {
    assert(!camera.mirrored);
    const Camera::Rays rays = camera.rays();
    const double distance = glm::distance(camera.position_m, camera.target_m);
    return shifted(camera, -distance * (pixels.x * rays.right + pixels.y * rays.up));
}

Camera zoomed(const Camera& camera, double notches, double nearest_m) {
    const glm::dvec3 back = camera.position_m - camera.target_m;
    const double distance = glm::length(back);
    const double wanted = std::clamp(distance * std::pow(0.9, notches), nearest_m, farthest_m);
    Camera next = camera;
    next.position_m = camera.target_m + wanted / distance * back;
    return next;
}

Camera flown(const Camera& camera, glm::dvec3 right_forward_up_m) {
    assert(!camera.mirrored);
    const Camera::Rays rays = camera.rays();
    return shifted(camera, right_forward_up_m.x * glm::normalize(rays.right) + right_forward_up_m.y * rays.forward +
                               glm::dvec3(0, 0, right_forward_up_m.z));
}

Camera turned(const Camera& camera, double azimuth_deg, double elevation_deg) {
    assert(!camera.mirrored);
    Camera next = camera;
    next.target_m = camera.position_m + turned(camera.target_m - camera.position_m, azimuth_deg, elevation_deg);
    return next;
}

}  // namespace waterlight
