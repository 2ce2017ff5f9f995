// Splats on the map, added up.
#pragma once

#include <array>

#include "caustics/splat/splat_cloud.hpp"

namespace waterlight {

/// A splat where it lies on the map. Lengths in pixels.
struct Splat {
    glm::dvec2 centre{0, 0};
    f32::SplatShape shape;
    float power_w = 0;
    std::array<f32::SplatEdge, 2> edges{};  ///< of the lattice, along each of its axes
    bool near_edge = false;

    /// Half of what it spans along x and y.
    glm::dvec2 reach() const;
};

/// A rectangle of the map's pixels.
struct MapPart {
    glm::ivec2 first{0, 0};
    Field<float> power_w;
};

/// Adds a splat to a part of the map. Returns how much of its light lies there, W.
float add_splat(const Splat& splat, MapPart& part);

/// That of vertex k of a cloud, by its neighbours' landing.
Splat splat_of(const SplatOptions& options, const SplatFrame& frame, const SplatCloud& cloud, int k);

/// Lays the light of all vertices on the map: W in each pixel. Completes the cloud's ledger. The same bytes whatever
/// the number of threads.
void spread(const SplatOptions& options, const SplatFrame& frame, SplatCloud& cloud, Field<double>& power_w);

}  // namespace waterlight
