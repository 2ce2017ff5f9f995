// One beam as a camera sees it: the numbers that its rays need, linear over the picture.
#pragma once

#include <array>

#include "caustics/beam_outline.hpp"
#include "caustics/beams.hpp"
#include "caustics/kernels/beams.hpp"

namespace waterlight {

/// The camera's rays r in the words of kernels/beams.glsl: (r_x, r_y, down), r = corner + i right + j up.
struct ViewRays {
    glm::vec3 corner, right, up;
    explicit ViewRays(const Camera::Rays& rays)
        : corner(down(rays.corner)), right(down(rays.right)), up(down(rays.up)) {}

  private:
    static glm::vec3 down(glm::dvec3 v) { return {v.x, v.y, -v.z}; }
};

/// A beam of a grid, moved by whole periods.
struct BeamCopy {
    int beam = 0;  ///< 2 i or 2 i + 1
    int row = 0;
    glm::vec2 shift_m{0, 0};
};

/// The numbers of a beam that are linear in a ray r. Of each edge those of EdgeForms.
enum BeamForm {
    along,
    across,
    leads,
    warps,
    numbers_of_edge,
    speed_x = 3 * numbers_of_edge,  ///< V of the mean travel
    speed_y,
    down,
    towards,  ///< |r| times the cosine between the light's way and the way to the camera
    beam_forms,
};

/// What one beam is to one camera.
struct BeamView {
    std::array<glm::vec3, beam_forms> form;  ///< dot with r
    glm::vec3 lid{0, 0, 0};                  ///< dot with r: speed towards the outside of the triangle on the surface
    float lid_distance = 0;                  ///< of the camera inside the triangle's plane, m
    float lowest_lid = 0;  ///< depth of the triangle's lowest corner below the camera, m; negative above it
    float above = 0;       ///< of the surface over the camera, m
    float path = 1;
    float power = 0;  ///< twice the flux over the cosine between light and vertical, W
};

/// The six corners of a beam relative to the camera: on the surface, then on the floor.
inline std::array<glm::vec3, 6> beam_corners(const Beams& b, BeamCopy copy, glm::dvec3 camera) {
    std::array<glm::vec3, 6> corners;
    const std::array<glm::ivec2, 3> at = corners_of(copy.beam, copy.row);
    const glm::vec3 from(camera);
    for (int k = 0; k < 3; ++k) {
        const int i = at[k].x, j = at[k].y;
        const glm::vec3 top{b.x(i, j) + copy.shift_m.x, b.y(i, j) + copy.shift_m.y, b.z(i, j)};
        const float descent = std::max(0.0F, top.z + static_cast<float>(b.depth_m));
        corners[k] = top - from;
        corners[k + 3] = corners[k] + descent * glm::vec3{b.travel_x(i, j), b.travel_y(i, j), -1};
    }
    return corners;
}

inline BeamView view_of(const Beams& b, BeamCopy copy, const std::array<glm::vec3, 6>& corners) {
    BeamView view;
    const std::array<glm::ivec2, 3> at = corners_of(copy.beam, copy.row);
    std::array<f32::BeamEdge, 3> edge;
    glm::vec2 mean{0, 0};  // travel
    float mean_z = 0, lowest = corners[0].z;
    view.path = 0;
    for (int k = 0; k < 3; ++k) {
        const int i = at[k].x, j = at[k].y;
        edge[k].travel = {b.travel_x(i, j), b.travel_y(i, j)};
        edge[k].at = glm::vec2(corners[k].x, corners[k].y) + corners[k].z * edge[k].travel;
        mean += edge[k].travel / 3.0F;
        view.path += b.path(i, j) / 3;
        mean_z += corners[k].z / 3;
        lowest = std::min(lowest, corners[k].z);
    }
    for (int k = 0; k < 3; ++k) {
        const f32::EdgeForms f = f32::edge_forms(edge[k], mean);
        glm::vec3* own = view.form.data() + k * numbers_of_edge;
        own[along] = f.along;
        own[across] = f.across;
        own[leads] = f.leads;
        own[warps] = f.warps;
    }
    view.form[speed_x] = {-1, 0, mean.x};
    view.form[speed_y] = {0, -1, mean.y};
    view.form[down] = {0, 0, 1};
    view.form[towards] = glm::vec3{-mean.x, -mean.y, -1} / view.path;
    const glm::vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    view.lid = {normal.x, normal.y, -normal.z};
    view.lid_distance = glm::dot(normal, corners[0]);
    view.lowest_lid = -lowest;
    view.above = mean_z;
    view.power = 2 * b.flux(copy.beam, copy.row) * view.path;
    return view;
}

}  // namespace waterlight
