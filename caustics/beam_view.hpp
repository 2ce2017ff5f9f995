// The two beams of a cell as a camera sees them: the numbers that its rays need, linear over the picture.
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

/// A cell of a grid of beams, moved by whole periods.
struct CellCopy {
    int column = 0;
    int row = 0;
    glm::vec2 shift_m{0, 0};
};

/// The numbers of a cell that are linear in a ray r. Of each of its four edges those of EdgeForms.
enum CellForm {
    along,
    across,
    leads,
    warps,
    numbers_of_edge,
    speed_x = 4 * numbers_of_edge,  ///< V of the mean travel
    speed_y,
    down,
    towards,  ///< |r| times the cosine between the light's way and the way to the camera
    lid,      ///< of both beams: speed towards the outside of the triangle on the surface
    cell_forms = lid + 2,
};

/// What a cell is to one camera. Its edges are counted around it; beam 0 has edges 0, 1, 2, beam 1 has 0, 2, 3.
struct CellView {
    std::array<glm::vec3, cell_forms> form;   ///< dot with r
    std::array<float, 2> lid_distance{0, 0};  ///< of the camera inside the triangle's plane, m
    std::array<float, 2> power{0, 0};  ///< twice the flux over the light's cosine to the vertical, W; 0 where discarded
    float lowest_lid = 0;  ///< depth of the lowest corner on the surface below the camera, m; negative above it
    float above = 0;       ///< of the surface over the camera, m
    float path = 1;
};

/// The corners of a cell as {column, row}, around it.
inline std::array<glm::ivec2, 4> corners_around(const CellCopy& c) {
    const int i = c.column, j = c.row;
    return {{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
}

/// The corners of a cell's beams relative to the camera: four on the surface, then four on the floor.
inline std::array<glm::vec3, 8> beam_corners(const Beams& b, const CellCopy& copy, glm::dvec3 camera) {
    std::array<glm::vec3, 8> corners;
    const std::array<glm::ivec2, 4> at = corners_around(copy);
    const glm::vec3 from(camera);
    for (int k = 0; k < 4; ++k) {
        const int i = at[k].x, j = at[k].y;
        const glm::vec3 top{b.x(i, j) + copy.shift_m.x, b.y(i, j) + copy.shift_m.y, b.z(i, j)};
        const float descent = std::max(0.0F, top.z - b.end_z(i, j));
        corners[k] = top - from;
        corners[k + 4] = corners[k] + descent * glm::vec3{b.travel_x(i, j), b.travel_y(i, j), -1};
    }
    return corners;
}

inline CellView view_of(const Beams& b, const CellCopy& copy, const std::array<glm::vec3, 8>& corners) {
    CellView view{};
    const std::array<glm::ivec2, 4> at = corners_around(copy);
    std::array<f32::BeamEdge, 4> edge;
    glm::vec2 mean{0, 0};  // travel
    float lowest = corners[0].z;
    view.path = 0;
    for (int k = 0; k < 4; ++k) {
        const int i = at[k].x, j = at[k].y;
        edge[k].travel = {b.travel_x(i, j), b.travel_y(i, j)};
        edge[k].at = glm::vec2(corners[k].x, corners[k].y) + corners[k].z * edge[k].travel;
        mean += 0.25F * edge[k].travel;
        view.path += 0.25F * b.path(i, j);
        view.above += 0.25F * corners[k].z;
        lowest = std::min(lowest, corners[k].z);
    }
    for (int k = 0; k < 4; ++k) {
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
    view.lowest_lid = -lowest;
    for (int beam = 0; beam < 2; ++beam) {
        const glm::vec3 v1 = corners[1 + beam] - corners[0], v2 = corners[2 + beam] - corners[0];
        const float flux = b.flux(2 * copy.column + beam, copy.row);
        if (!(flux > 0)) continue;
        const glm::vec3 normal = glm::normalize(glm::cross(v1, v2));
        view.form[lid + beam] = {normal.x, normal.y, -normal.z};
        view.lid_distance[beam] = glm::dot(normal, corners[0]);
        view.power[beam] = 2 * flux * view.path;
    }
    return view;
}

}  // namespace waterlight
