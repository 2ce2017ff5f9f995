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
        /// surface where the sun meets water first and last: neither objects nor ground as high as it, no wave so steep
        /// that it stands in another's light; else light
        automatic,
        light,   ///< cells of the light's image of the scene
        surface  ///< cells of the water's surface; what objects stand before ends on them. The light is the sun
    };
    enum class Branching {
        roulette,  ///< one way is followed, chosen by its share
        split      ///< both are, each with its share, as long as it carries more than a thousandth of the photon
    };
    Start start = Start::automatic;
    Branching branching = Branching::roulette;
    int map = 512;     ///< photons of a pass along each axis of where they start, stratified, in [1, 65536]
    int passes = 1;    ///< at most; each draws anew, >= 1; with a tolerance >= 2
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

/// What passes have brought so far: all that it takes to go on with more.
struct PhotonSums {
    int passes = 0;
    Field<double> power_w{};  ///< landed on each pixel, of all passes; on sloping ground as irradiance is per its area
    Field<double> squares_w2{};  ///< sum of the squares of what each pass landed, smoothed as the map is
    FloorLedger ledger{};        ///< of all passes
};

/// Follows photons; the map is what landed, each whole on its pixel. incident_w is what comes in over the domain,
/// through its surface or by objects, those beyond its walls among them; reflected_w what leaves upwards, by whatever
/// way; objects_w what ends on or in them; lost_w what met too many interfaces. Of a periodic side the map may show
/// more than one period: what it shows again counts as entered. Beyond absorbing sides the water is still, below it
/// there is no ground but the flat floor. The bytes do not depend on the number of threads.
class PhotonFloor : public FloorMapper {
  public:
    /// Of the last map, from the scatter between its passes: the standard error of its pixels, root mean square over
    /// that of the map. It knows nothing of what smoothing does to the map (blur.hpp). NaN where there was one pass
    /// only.
    virtual double error_estimate() const = 0;
    virtual int passes() const = 0;
    virtual std::int64_t photons() const = 0;  ///< of all its passes

    /// Follows as many more passes through this surface: 3 and then 5 are 8, bit for bit. Begins where there are none.
    virtual void add(const Surface& surface, int passes, PhotonSums& sums) const = 0;
    /// The map of at least one pass.
    virtual void show(const Surface& surface, const PhotonSums& sums, FloorMap& map) = 0;
};

/// Throws InputError where a setting is out of its range.
std::unique_ptr<PhotonFloor> make_photon_floor(const PhotonSettings& settings);

}  // namespace waterlight
