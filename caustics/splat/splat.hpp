// The floor map by caustics mapping (Shah, Konttinen & Pattanaik, "Caustics Mapping: An Image-space Technique for
// Real-time Caustics", IEEE TVCG 13 (2007)): a grid of vertices on what refracts or reflects, as the light sees it;
// each is moved along its ray to where an iteration in the light's image lands it, and splatted there.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "caustics/floor.hpp"
#include "caustics/objects/lamp.hpp"
#include "caustics/objects/object_set.hpp"

namespace waterlight {

struct SplatOptions {
    enum class Size {
        jacobian,  ///< Gaussians of the footprint of each vertex: converges
        fixed      ///< the same Gaussian for all, `radius_pixels`, as in the paper
    };
    enum class Landing {
        height,   ///< each step to where the ray is as high as the receiver seen: exact on level ground under any light
        distance  ///< each step as far as the receiver seen, as in the paper: diverges under a low sun
    };
    int grid = 512;      ///< vertices along the longer axis of the domain, in [2, 16384]
    int iterations = 8;  ///< of the landing, in [1, 1000]
    Landing landing = Landing::height;
    Size size = Size::jacobian;
    double radius_pixels = 0.6;  ///< standard deviation of a fixed splat, > 0
    int bounces = 8;             ///< interfaces that a vertex's light may meet where there are objects, in [1, 1000]
};

struct SplatSettings {
    FloorSettings floor;  ///< window, footprint and samples_per_pixel are not used; `sun` is where `lamp` is none
    SplatOptions options{};
    std::optional<Lamp> lamp{};  ///< in place of the sun
    std::shared_ptr<const Field<float>>
        bed_m{};                  ///< heights of the ground on the surface's cells; none: the flat floor
    bool per_ground_area = true;  ///< what irradiance on `bed_m` is per, as of ReliefSettings
};

/// What became of the vertices of the last map.
struct SplatReport {
    std::int64_t vertices = 0;       ///< whose light goes down to a receiver
    std::int64_t not_converged = 0;  ///< whose last step of the landing was longer than a pixel; splatted all the same
    std::int64_t missed = 0;         ///< whose landing left the light's image, or found no receiver there
    double last_step_m = 0;          ///< root mean square of the last step of all that landed
};

class SplatFloor : public FloorMapper {
  public:
    virtual SplatReport report() const = 0;
};

/// Throw InputError where a setting is out of its range.
std::unique_ptr<SplatFloor> make_splat_floor_cpu(const SplatSettings& settings);
// On Vulkan: caustics/splat/splat_vulkan.hpp.

}  // namespace waterlight
