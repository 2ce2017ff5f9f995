// All that light can meet at one time: water, the ground, the sides of the domain, objects. And what becomes of it
// there.
#pragma once

#include <memory>
#include <optional>

#include "caustics/light.hpp"
#include "caustics/objects/object_set.hpp"
#include "caustics/objects/triangle_scene.hpp"
#include "sim/sines.hpp"
#include "sim/surface.hpp"

namespace waterlight {

struct WaterSceneSettings {
    double depth_m = 1;  ///< floor at z = -depth, > 0; not used with `bed_m`
    std::shared_ptr<const Field<float>>
        bed_m{};  ///< heights of the ground on the surface's cells; none: the flat floor
    WaterOptics optics{};
    double wavelength_nm = 587.6;  ///< for the index of glass
    std::shared_ptr<const ObjectSet> objects{};
    double still_beyond_m = 0;  ///< width of the still water that lies beyond absorbing sides, >= 0
};

/// Light on its way.
struct Traveller {
    Ray ray{};
    bool in_water = false;  ///< what surrounds the objects there: water, or air
    int inside = -1;        ///< the object within which it travels; -1: none
};

struct SceneHit {
    enum class What { nothing, water, floor, side, object };
    What what = What::nothing;
    double distance_m = 0;
    glm::dvec3 normal{0, 0, 1};  ///< unit: up of water and floor, into the domain of a side, out of an object
    int object = -1;
    glm::ivec2 side{0, 0};  ///< outwards: {-1, 0} is the west side
};

/// The two ways on from a boundary of clear media, and the share that takes the second.
struct Branches {
    Traveller reflected, refracted;
    double transmittance = 0;  ///< 0 where all is reflected; refracted then has no meaning
};

/// Never changes; any number of threads at once.
class WaterScene {
  public:
    /// The surface is copied into triangles; its slopes are read where light meets it, so it must outlive the scene.
    WaterScene(const WaterSceneSettings& settings, const Surface& surface);
    ~WaterScene();
    WaterScene(WaterScene&&) noexcept;

    /// What a traveller meets first. Sides are met from within the water alone, and not where they are absorbing: there
    /// the floor goes on.
    SceneHit first_hit(const Traveller& traveller) const;
    /// At water or glass that it meets. A mirror has the first way alone, with transmittance 0.
    Branches branch(const Traveller& traveller, const SceneHit& hit) const;
    /// Of a traveller that meets a periodic side: the same where it comes in again, at its height: of tilted water,
    /// which climbs from period to period, light from the surface to the floor is right and light from below is not.
    Traveller wrapped(const Traveller& traveller, const SceneHit& hit) const;

    /// Coefficient (1/m) of what the medium takes from a traveller: in water extinction, in glass absorption.
    double extinction_per_m(const Traveller& traveller) const;
    bool is_under_water(glm::dvec3 at_m) const;
    /// Elevation and slope of the surface.
    SurfacePoint surface_at(glm::dvec2 at_m) const;
    double lowest_floor_m() const;
    double highest_water_m() const;
    const PlacedObjects& objects() const;
    const Surface& surface() const;
    const WaterSceneSettings& settings() const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace waterlight
