// Irradiance in the water from beams: two fields on a grid of cells below the domain.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "caustics/beams.hpp"

namespace waterlight {

/// Where the light of one slice is, in watts: in the water at that depth = on the grid + left through the sides.
struct SliceLedger {
    double flux_w = 0;
    double inside_w = 0;
    double outside_w = 0;
    /// What would pass here of the light that objects in the water stopped above, ground aside: with it flux_w is that
    /// of water without objects, less what they shade from above.
    double objects_w = 0;
};

/// nx by ny by nz cells over the domain, from the floor (or the lowest ground) to still water. A value is the mean over
/// a cell's horizontal section through its middle. Slice 0 is the deepest; slice k holds rows k ny to (k + 1) ny - 1 of
/// the fields.
struct BeamVolume {
    glm::ivec3 cells{1, 1, 1};
    Field<float> plane_irradiance;   ///< W/m2, downward, on the horizontal plane
    Field<float> scalar_irradiance;  ///< W/m2, of a plane that faces each beam, summed
    std::vector<SliceLedger> ledger;
    double depth_m = 1;     ///< of the lower end, as of the beams
    Field<float> ground_m;  ///< its height in the middle of each column, m; empty over a flat floor

    /// Whether the middle of a slice's cell n, counted along x first, is above the ground.
    bool above_ground(std::size_t n, int k) const { return ground_m.empty() || z_m(k) > ground_m.data()[n]; }
    double z_m(int k) const { return ((k + 0.5) / cells.z - 1) * depth_m; }
    std::span<const float> plane(int k) const { return slice(plane_irradiance, k); }
    std::span<const float> scalar(int k) const { return slice(scalar_irradiance, k); }

  private:
    std::span<const float> slice(const Field<float>& f, int k) const {
        const std::size_t size = static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y);
        return f.values().subspan(k * size, size);
    }
};

/// Each beam's section at each depth is the triangle of its three rays, its flux spread evenly over it and shared
/// exactly among the cells. Unscattered light only: what is absorbed or scattered on the way is gone. Periodic sides
/// wrap; what leaves through others is in the ledger. Above the troughs, and below where its light ends on ground, only
/// the part of a beam that is in the water counts; a cell in the ground, or in shadow, is 0. `volume` is reused where
/// its size fits. Throws InputError where a count is below 1.
void fill_volume(const Beams& beams, glm::ivec3 cells, BeamVolume& volume);

/// Makes `volume` fit the beams, its ledger empty but for what objects stopped. Throws InputError where a count is
/// below 1.
void fit(const Beams& beams, glm::ivec3 cells, BeamVolume& volume);

/// Adds fields, and what their ledgers say of the light that passes, of the same cells.
void add(const BeamVolume& more, BeamVolume& volume);

}  // namespace waterlight
