// The water's surface as meshes: one for each distance at which copies of the domain lie, and what is beyond them; and
// the ground's.
#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "render/frame.hpp"

namespace waterlight {

/// A mesh of columns by rows over a rectangle in cells of the surface, drawn once for each of a row of copies.
struct WaterMesh {
    glm::vec4 rectangle{0, 0, 0, 0};  ///< u0, v0, u1, v1
    int columns = 1;
    int rows = 1;
    SurfaceLevel level;
    bool coarse = false;
    int first_copy = 0;
    int copies = 1;
};

struct WaterMeshes {
    std::vector<WaterMesh> meshes;
    std::vector<WaterMesh> ground;  ///< none over a flat floor
    std::vector<glm::vec4> shifts;  ///< of all copies, m
};

/// Meshes no finer than this camera can tell: what lies between their corners differs from the surface by less than one
/// and a half pixels almost everywhere. Periodic sides repeat the domain as far as 160 m or 10 copies, then the water
/// is flat with the mean variance of its slopes; beyond absorbing sides it is flat and still. A tilted surface climbs
/// as it repeats, and ends there.
WaterMeshes plan_water(const Frame& frame);

/// The push constants that draw a mesh, and what of it is drawn.
PassParameters mesh_parameters(const PassParameters& view, const WaterMesh& mesh);
gpu::Strips strips_of(const WaterMesh& mesh);

}  // namespace waterlight
