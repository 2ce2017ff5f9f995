// The two beams of a cell as a camera sees them: the numbers that its rays need, linear over the picture.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "caustics/beams.hpp"
#include "caustics/camera.hpp"
#include "caustics/kernels/beams.hpp"

namespace waterlight {

/// From where a picture is seen, in the world of its beams: every ray of a picture, and its eye, comes from here.
struct Viewpoint {
    glm::dvec3 eye_m;
    Camera::Rays rays;
    explicit Viewpoint(const Camera& camera) : eye_m(camera.position_m), rays(camera.rays()) {}
};

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
    towards,                   ///< |r| times the cosine between the light's way and the way to the camera
    top_lid,                   ///< of both beams: speed towards the outside of the triangle on the surface
    ground_lid = top_lid + 2,  ///< and of that on the ground
    cell_forms = ground_lid + 2,
};

/// What a cell is to one camera. Its edges are counted around it; beam 0 has edges 0, 1, 2, beam 1 has 0, 2, 3.
struct CellView {
    std::array<glm::vec3, cell_forms> form;      ///< dot with r
    std::array<f32::BeamEdge, 4> edge;           ///< with travel less the mean
    float off2 = 0;                              ///< the most of it, squared
    std::array<float, 2> top_distance{0, 0};     ///< of the camera inside the triangle's plane, m
    std::array<float, 2> ground_distance{0, 0};  ///< above the plane of its end
    std::array<float, 2> power{0, 0};  ///< twice the flux over the light's cosine to the vertical, W; 0 where discarded
    float lowest_lid = 0;   ///< depth of the lowest corner on the surface below the camera, m; negative above it
    float highest_end = 0;  ///< depth of the highest corner on the ground below the camera, m
    float above = 0;        ///< of the surface over the camera, m
    float path = 1;
};

/// The corners of a cell as {column, row}, around it.
inline std::array<glm::ivec2, 4> corners_around(const CellCopy& c) {
    const int i = c.column, j = c.row;
    return {{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
}

/// The corners of a cell's beams relative to the eye: four on the surface, then four where their light ends.
inline std::array<glm::vec3, 8> beam_corners(const Beams& b, const CellCopy& copy, glm::dvec3 eye) {
    std::array<glm::vec3, 8> corners;
    const std::array<glm::ivec2, 4> at = corners_around(copy);
    const glm::vec3 from(eye);
    for (int k = 0; k < 4; ++k) {
        const int i = at[k].x, j = at[k].y;
        const glm::vec3 top{b.x(i, j) + copy.shift_m.x, b.y(i, j) + copy.shift_m.y, b.z(i, j)};
        const float descent = std::max(0.0F, top.z - b.end_z(i, j));
        corners[k] = top - from;
        corners[k + 4] = corners[k] + descent * glm::vec3{b.travel_x(i, j), b.travel_y(i, j), -1};
    }
    return corners;
}

/// Whether all light ends at the depth where every camera ray does, so that no beam need be cut there.
inline bool ends_level(const Beams& b) {
    return std::ranges::all_of(b.end_z.values(),
                               [level = static_cast<float>(-b.depth_m)](float z) { return z == level; });
}

inline CellView view_of(const Beams& b, const CellCopy& copy, const std::array<glm::vec3, 8>& corners) {
    CellView view{};
    const std::array<glm::ivec2, 4> at = corners_around(copy);
    std::array<f32::BeamEdge, 4> edge;
    glm::vec2 mean{0, 0};  // travel
    float lowest = corners[0].z, highest_end = corners[4].z;
    view.path = 0;
    for (int k = 0; k < 4; ++k) {
        const int i = at[k].x, j = at[k].y;
        edge[k] = f32::beam_edge(corners[k], {b.travel_x(i, j), b.travel_y(i, j)});
        mean += 0.25F * edge[k].travel;
        view.path += 0.25F * b.path(i, j);
        view.above += 0.25F * corners[k].z;
        lowest = std::min(lowest, corners[k].z);
        highest_end = std::max(highest_end, corners[k + 4].z);
    }
    for (int k = 0; k < 4; ++k) {
        const f32::EdgeForms f = f32::edge_forms(edge[k], mean);
        glm::vec3* own = view.form.data() + k * numbers_of_edge;
        own[along] = f.along;
        own[across] = f.across;
        own[leads] = f.leads;
        own[warps] = f.warps;
        view.edge[k] = {edge[k].at, edge[k].travel - mean};
    }
    view.off2 = f32::largest_off2(view.edge[0].travel, view.edge[1].travel, view.edge[2].travel, view.edge[3].travel);
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 r{0, 0, 0};
        r[axis] = 1;
        const glm::vec2 speed = f32::speed_past(mean, r);
        view.form[speed_x][axis] = speed.x;
        view.form[speed_y][axis] = speed.y;
        view.form[down][axis] = r.z;
        view.form[towards][axis] = f32::towards_eye(mean, view.path, r);
    }
    view.lowest_lid = -lowest;
    view.highest_end = -highest_end;
    for (int beam = 0; beam < 2; ++beam) {
        const float flux = b.flux(2 * copy.column + beam, copy.row);
        if (!(flux > 0)) continue;
        const f32::BeamLid top = f32::upper_lid(corners[0], corners[1 + beam], corners[2 + beam]);
        const f32::BeamLid ground = f32::lower_lid(corners[4], corners[5 + beam], corners[6 + beam], {mean, -1});
        view.form[top_lid + beam] = top.outward;
        view.form[ground_lid + beam] = ground.outward;
        view.top_distance[beam] = top.distance;
        view.ground_distance[beam] = ground.distance;
        view.power[beam] = 2 * flux * view.path;
    }
    return view;
}

}  // namespace waterlight
