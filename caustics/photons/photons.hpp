// The floor map by photon mapping from the light's view (Kim, "Caustics Using Screen-Space Photon Mapping", Ray Tracing
// Gems, 2019): photons leave the light's image of the scene, or the water's surface itself, and are followed through
// water and objects until they are absorbed or land. The only method here that follows light through everything.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "caustics/floor.hpp"
#include "caustics/objects/lamp.hpp"
#include "caustics/objects/object_set.hpp"

namespace waterlight {

struct PhotonOptions {
    enum class Start {
        automatic,  ///< surface where the sun meets nothing but water first, else light
        light,      ///< cells of the light's image of the scene
        surface     ///< cells of the water's surface; the light meets no object before it, and is the sun
    };
    enum class Branching {
        roulette,  ///< one way is followed, chosen by its share
        split      ///< both are, each with its share, as long as it carries more than a thousandth of the photon
    };
    Start start = Start::automatic;
    Branching branching = Branching::roulette;
    int map = 512;     ///< photons of a pass along each axis of where they start, stratified, in [1, 65536]
    int passes = 1;    ///< at most; each draws anew, >= 1
    int bounces = 16;  ///< interfaces met at most; what then still travels is lost, >= 1
    /// Where passes end: the relative error of the map by its own estimate; 0: after `passes`.
    double tolerance = 0;
    double blur_pixels = 0;  ///< standard deviation of the Gaussian that smooths the map; 0: none
    std::uint64_t seed = 1;
};

struct PhotonSettings {
    FloorSettings floor;  ///< window, footprint and samples_per_pixel are not used; `sun` is where `lamp` is none
    PhotonOptions options{};
    std::optional<Lamp> lamp{};  ///< in place of the sun
    std::shared_ptr<const Field<float>>
        bed_m{};                  ///< heights of the ground on the surface's cells; none: the flat floor
    bool per_ground_area = true;  ///< what irradiance on `bed_m` is per, as of ReliefSettings
};

/// Follows photons; the map is what landed. A ledger's reflected_w is what leaves upwards, by whatever way; objects_w
/// what ends on or in them; lost_w what met too many interfaces.
class PhotonFloor : public FloorMapper {
  public:
    /// Of the last map, from the scatter between its passes' parts: the standard error of its pixels, root mean square
    /// over that of the map. NaN where there was one part only.
    virtual double error_estimate() const = 0;
    virtual int passes() const = 0;
    virtual std::int64_t photons() const = 0;  ///< of all its passes
};

/// Throws InputError where a setting is out of its range.
std::unique_ptr<PhotonFloor> make_photon_floor(const PhotonSettings& settings);

}  // namespace waterlight
