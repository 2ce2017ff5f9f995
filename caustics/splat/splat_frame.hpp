// What both back-ends of caustics mapping share: the light, the lattice of vertices, where the map lies.
#pragma once

#include <glm/mat2x2.hpp>

#include "caustics/kernels/splat.hpp"
#include "caustics/splat/splat.hpp"

namespace waterlight {

/// Vertices at the centres of rectangles of spacing_m; rectangles (0, 0) to (nx - 1, ny - 1) fill the domain, others
/// lie beside it. (first, count) of them are followed.
struct VertexLattice {
    glm::dvec2 corner_m{0, 0};  ///< of the domain
    glm::dvec2 spacing_m{1, 1};
    glm::ivec2 domain{1, 1};  ///< vertices
    glm::ivec2 first{0, 0}, count{1, 1};

    glm::dvec2 place_m(glm::ivec2 vertex) const { return corner_m + (glm::dvec2(vertex) + 0.5) * spacing_m; }
    bool in_domain(glm::ivec2 v) const { return v.x >= 0 && v.x < domain.x && v.y >= 0 && v.y < domain.y; }
    double area_m2() const { return spacing_m.x * spacing_m.y; }
};

/// So many vertices on each side of what is followed have no light: for differences, and as mirror images at walls.
inline constexpr int vertex_rim = 4;

struct SplatFrame {
    f64::SplatLight light;
    VertexLattice lattice;
    double index = 1, fresnel = 1, extinction_per_m = 0;
    FloorPlan plan;
    glm::dmat2 to_pixels{1};  ///< of metres on the floor
    double pixel_area_m2 = 1;
    double pixel_m = 1;             ///< its shorter side
    glm::bvec2 ends{false, false};  ///< whether the lattice's light ends with the domain
    glm::dvec2 period_m{0, 0};      ///< after which what lands repeats; 0: it does not
};

/// Throws InputError where a setting is out of its range.
void validate(const SplatSettings& settings);

/// The lattice is that of the domain, which whoever captures vertices widens.
SplatFrame splat_frame(const SplatSettings& settings, const Surface& surface);

using BoxM = std::pair<glm::dvec2, glm::dvec2>;  ///< low and high corner

/// By how much light moves at least and at most on its way down along each axis: where it enters still water, or waves
/// that climb.
BoxM light_shifts(const SplatSettings& settings, const SplatFrame& frame, const Surface& surface);

/// The vertices of `lit`, and beside them those whose light may land on the map where there is water: beyond absorbing
/// sides, and beyond periodic ones that the surface climbs over (else its light wraps). Around all, the rim. Throws
/// InputError where they are too many.
void widen_lattice(SplatFrame& frame, const Surface& surface, const BoxM& shifts_m, const BoxM& lit_m);

/// The corners of the box about the map in the domain's directions.
BoxM box_about(const FloorPlan& plan);

/// The level of the light's image: the floor, or the lowest ground.
double image_level_m(const SplatSettings& settings);

}  // namespace waterlight
