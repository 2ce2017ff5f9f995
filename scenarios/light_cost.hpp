// What the light of a scene costs in time.
#pragma once

#include "scenarios/choose.hpp"

namespace waterlight {

/// Of cells or pixels, which may be more than an int counts.
inline double product(glm::ivec2 n) { return n.x * static_cast<double>(n.y); }

/// Seconds of floor map, walls, beams, fields and pictures over the whole run, from scenarios/costs.hpp, once cells,
/// pixels and beams are known. A picture counts as if the beams filled it.
double light_seconds(const Scenario& scenario, const LightDemand& light, glm::ivec2 cells);

/// Of the method splat; over the domain.
double vertices_of(const Scenario& scenario);
/// Of the method photons; of all passes of a map.
double photons_of(const Scenario& scenario);

/// Of the pictures of the scene, traced on the CPU or on a Vulkan device that is the CPU; a GPU takes far less.
double scene_seconds(const Scenario& scenario);

}  // namespace waterlight
