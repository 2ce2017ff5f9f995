#include "caustics/picture_ground.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "caustics/beam_view.hpp"

namespace waterlight {

namespace {

/// The t between 0 and `end` at which the ray goes below the ground.
double first_meeting(const PictureGround& ground, glm::dvec3 eye, glm::dvec3 r, double end) {
    const auto above = [&](double t) {
        const glm::dvec3 at = eye + t * r;
        return at.z - ground.height_m(glm::dvec2(at));
    };
    // Steep rays step by height: ground is met between two steps only where it rises as fast as they fall.
    const double step = ground.step_m / std::max(glm::length(glm::dvec2(r)), std::abs(r.z));
    double last = eye.z > ground.highest_m && r.z < 0 ? std::min(end, (ground.highest_m - eye.z) / r.z) : 0;
    while (last < end) {
        if (r.z >= 0 && eye.z + last * r.z > ground.highest_m) break;
        double next = std::min(end, last + step);
        if (above(next) <= 0) {
            for (int halving = 0; halving < 10; ++halving) {
                const double middle = 0.5 * (last + next);
                (above(middle) <= 0 ? next : last) = middle;
            }
            return 0.5 * (last + next);
        }
        last = next;
    }
    return end;
}

}  // namespace

Field<float> ground_reach(const Camera& camera, const PictureGround& ground, double range_m) {
    const Viewpoint view(camera);
    Field<float> reach(camera.size.x, camera.size.y);
#pragma omp parallel for schedule(dynamic, 4)
    for (int j = 0; j < camera.size.y; ++j)
        for (int i = 0; i < camera.size.x; ++i) {
            const glm::dvec3 r = view.rays.at(i, j);
            reach(i, j) = static_cast<float>(first_meeting(ground, view.eye_m, r, range_m / glm::length(r)));
        }
    return reach;
}

}  // namespace waterlight
