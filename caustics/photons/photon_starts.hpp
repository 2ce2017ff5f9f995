// Where photons set out: cells of the light's image of the scene, or of the water's surface.
#pragma once

#include <memory>

#include "caustics/photons/photon_path.hpp"

namespace waterlight {

/// A level rectangle.
struct LevelBox {
    glm::dvec2 low_m{0, 0}, high_m{0, 0};

    glm::dvec2 size_m() const { return high_m - low_m; }
    void hold(glm::dvec2 at_m) {
        low_m = glm::min(low_m, at_m);
        high_m = glm::max(high_m, at_m);
    }
};

/// The water through which light may come to the domain or, beyond absorbing sides, from still water to the map.
LevelBox lit_water(const PhotonSettings& settings, const Surface& surface);

/// Cells of equal size on the unit square; each photon is thrown at random within its own.
class PhotonStarts {
  public:
    virtual ~PhotonStarts() = default;
    /// The photon from a place in the unit square, with the power that the whole square would have if all of it were
    /// as this place is.
    virtual Photon start(glm::dvec2 place) const = 0;
};

/// As the options say. What it is given must outlive it.
std::unique_ptr<PhotonStarts> make_photon_starts(const PhotonSettings& settings, const WaterScene& scene);

/// Whether automatic starts are on the surface: the light is the sun, no wave stands in its way, and neither ground nor
/// object is as high as the lowest water.
bool starts_on_surface(const PhotonSettings& settings, const Surface& surface, const PlacedObjects& objects);

}  // namespace waterlight
