// One photon's way through water and objects.
#pragma once

#include <optional>
#include <vector>

#include "caustics/floor.hpp"
#include "caustics/objects/water_scene.hpp"
#include "caustics/photons/photon_random.hpp"
#include "caustics/photons/photons.hpp"

namespace waterlight {

/// Light that has just set out.
struct Photon {
    Traveller way{};
    double power_w = 0;
    std::optional<SceneHit> first{};  ///< what it meets first, where that is known
    bool blocked = false;             ///< an object stands before it and stops it
};

/// Where light ends: on the floor, or on a diffuse object.
struct PhotonLanding {
    glm::dvec3 at_m{0, 0, 0};
    glm::dvec3 normal{0, 0, 1};  ///< unit, out of what it lands on
    double power_w = 0;
    int object = -1;  ///< -1: the floor
    bool own = true;  ///< whether it came in over the domain or by an object; else the ledger counts it as entered
};

/// A photon on its way, and what is left of it.
struct PhotonPath {
    Traveller way{};
    double power_w = 0;
    double least_w = 0;  ///< less than this is not divided
    bool own = true;
    int met = 0;    ///< interfaces
    int round = 0;  ///< periodic sides
};

/// What became of some photons. The ledger lacks what landed on the floor: that is for whoever knows the map.
struct PhotonTally {
    FloorLedger ledger{};
    std::vector<PhotonLanding> landings{};
    std::vector<PhotonPath> waiting{};  ///< parts of the photon being followed
};

/// A domain's sides, as light above and below the water meets them.
struct PhotonDomain {
    glm::dvec2 low_m{0, 0}, size_m{1, 1};
    Boundary boundary{};
    glm::dvec2 climb_m{0, 0};  ///< of the water from period to period, 0 where a side is not periodic

    explicit PhotonDomain(const Surface& surface);
    bool periodic(int axis) const { return side(axis) == Side::periodic; }
    Side side(int axis) const { return axis == 0 ? boundary.x : boundary.y; }
    bool holds(glm::dvec2 at_m) const;
    bool is_beyond_wall(glm::dvec2 at_m) const;
    /// The same place by whole periods within the domain; above the water, lower by what that climbs.
    glm::dvec3 brought_in(glm::dvec3 at_m, bool in_water) const;
};

/// Light that objects or water meet first is counted where that happens: all of it over the domain and on objects is
/// incident, what meets the water beyond an absorbing side is counted only if it lands on the map, the rest is none of
/// ours. Above the water periodic sides lead round as they do below it. What of an object stands beyond a periodic side
/// is met only by light that goes through it: the scene is to hold the object again where it comes in.
class PhotonFollower {
  public:
    /// `scene` must outlive it.
    PhotonFollower(const WaterScene& scene, const PhotonOptions& options);
    void follow(const Photon& photon, PhotonRandom& random, PhotonTally& tally) const;

  private:
    SceneHit next_hit(const Traveller& way) const;
    /// Whether it is on its way out and meets nothing more.
    bool leaves(const Traveller& way) const;
    bool sets_out(const SceneHit& hit, PhotonPath& path, PhotonTally& tally) const;
    bool step(const SceneHit& hit, PhotonPath& path, PhotonRandom& random, PhotonTally& tally) const;
    bool meet_object(const SceneHit& hit, PhotonPath& path, PhotonTally& tally) const;
    bool meet_side(const SceneHit& hit, PhotonPath& path, PhotonTally& tally) const;
    void go_round(const SceneHit& hit, PhotonPath& path) const;
    bool has_slipped(const SceneHit& hit, const Traveller& way) const;
    bool divide(const SceneHit& hit, PhotonPath& path, PhotonRandom& random, PhotonTally& tally) const;
    void land(const SceneHit& hit, const PhotonPath& path, PhotonTally& tally) const;
    void fade(const SceneHit& hit, PhotonPath& path, PhotonTally& tally) const;

    const WaterScene& scene_;
    PhotonOptions options_;
    PhotonDomain domain_;
    double steepest_;          ///< slope of the water
    double highest_ground_m_;  ///< below everything where the floor is flat
};

}  // namespace waterlight
