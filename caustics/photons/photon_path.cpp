#include "caustics/photons/photon_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "caustics/kernels/optics.hpp"
#include "caustics/surface_point.hpp"

namespace waterlight {

using What = SceneHit::What;

PhotonDomain::PhotonDomain(const Surface& surface)
    : low_m(surface.grid.x0_m, surface.grid.y0_m),
      size_m(surface.grid.width_m(), surface.grid.height_m()),
      boundary(surface.boundary) {
    for (int axis = 0; axis < 2; ++axis) climb_m[axis] = periodic(axis) ? surface.tilt[axis] * size_m[axis] : 0;
}

bool PhotonDomain::holds(glm::dvec2 at_m) const {
    for (int axis = 0; axis < 2; ++axis) {
        const double within = at_m[axis] - low_m[axis];
        if (!periodic(axis) && (within < 0 || within > size_m[axis])) return false;
    }
    return true;
}

bool PhotonDomain::is_beyond_wall(glm::dvec2 at_m) const {
    for (int axis = 0; axis < 2; ++axis) {
        const double within = at_m[axis] - low_m[axis];
        if (side(axis) == Side::wall && (within < 0 || within > size_m[axis])) return true;
    }
    return false;
}

glm::dvec3 PhotonDomain::brought_in(glm::dvec3 at_m, bool in_water) const {
    for (int axis = 0; axis < 2; ++axis) {
        if (!periodic(axis)) continue;
        const double within = at_m[axis] - low_m[axis];
        if (within >= 0 && within <= size_m[axis]) continue;
        const double periods = std::floor(within / size_m[axis]);
        at_m[axis] -= periods * size_m[axis];
        if (!in_water) at_m.z -= periods * climb_m[axis];
    }
    return at_m;
}

namespace {

/// Ways that lead round more often than this never end.
constexpr int most_rounds = 1 << 14;
/// Of the photon as it set out: what carries less is not divided.
constexpr double least_share = 1e-3;

void count(double& row, double power_w, bool own) {
    if (own) row += power_w;
}

double highest(const std::shared_ptr<const Field<float>>& bed) {
    return bed ? *std::ranges::max_element(bed->values()) : -std::numeric_limits<double>::infinity();
}

/// Whether a ray meets a box in front of it.
bool meets_box(const Ray& ray, glm::dvec3 low, glm::dvec3 high) {
    double from = 0, to = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double speed = ray.direction[axis], a = low[axis] - ray.from_m[axis], b = high[axis] - ray.from_m[axis];
        if (speed == 0) {
            if (a > 0 || b < 0) return false;
            continue;
        }
        from = std::max(from, std::min(a / speed, b / speed));
        to = std::min(to, std::max(a / speed, b / speed));
    }
    return from <= to;
}

}  // namespace

PhotonFollower::PhotonFollower(const WaterScene& scene, const PhotonOptions& options)
    : scene_(scene),
      options_(options),
      domain_(scene.surface()),
      steepest_(steepest_slope(scene.surface())),
      highest_ground_m_(highest(scene.settings().bed_m)) {}

bool PhotonFollower::leaves(const Traveller& way) const {
    const Ray& ray = way.ray;
    if (way.in_water || way.inside >= 0 || ray.from_m.z < highest_ground_m_) return false;
    const bool above = domain_.climb_m == glm::dvec2{0, 0} && ray.from_m.z > scene_.highest_water_m();
    if (ray.direction.z <= (above ? 0 : steepest_ * glm::length(glm::dvec2(ray.direction)))) return false;
    const glm::dvec3 low = scene_.objects().low_m(), high = scene_.objects().high_m();
    if (low.z > high.z || ray.from_m.z >= high.z) return true;
    return !domain_.periodic(0) && !domain_.periodic(1) && !meets_box(ray, low, high);
}

/// Of the scene, or a periodic side above the water.
SceneHit PhotonFollower::next_hit(const Traveller& way) const {
    SceneHit hit = scene_.first_hit(way);
    if (way.in_water || way.inside >= 0) return hit;
    for (int axis = 0; axis < 2; ++axis) {
        const double speed = way.ray.direction[axis];
        if (!domain_.periodic(axis) || speed == 0) continue;
        const double side = domain_.low_m[axis] + (speed > 0 ? domain_.size_m[axis] : 0);
        const double t = std::max(0.0, (side - way.ray.from_m[axis]) / speed);
        if (t >= hit.distance_m) continue;
        hit = {What::side, t, {0, 0, 0}, -1, {0, 0}};
        hit.side[axis] = speed > 0 ? 1 : -1;
    }
    return hit;
}

void PhotonFollower::follow(const Photon& photon, PhotonRandom& random, PhotonTally& tally) const {
    PhotonPath path{photon.way, photon.power_w,
                    options_.branching == PhotonOptions::Branching::split ? least_share * photon.power_w
                                                                          : std::numeric_limits<double>::infinity()};
    path.way.ray.from_m = domain_.brought_in(path.way.ray.from_m, path.way.in_water);
    SceneHit hit = photon.first ? *photon.first : next_hit(path.way);
    while (hit.what == What::side && !path.way.in_water && path.round < most_rounds) {
        go_round(hit, path);
        if (leaves(path.way)) return;
        hit = next_hit(path.way);
    }
    if (!sets_out(hit, path, tally)) return;
    if (photon.blocked) return count(tally.ledger.objects_w, path.power_w, path.own);
    while (true) {
        while (step(hit, path, random, tally)) hit = next_hit(path.way);
        if (tally.waiting.empty()) return;
        path = tally.waiting.back();
        tally.waiting.pop_back();
        hit = next_hit(path.way);
    }
}

/// Whose account it is. False where it is nobody's: it passes by, meets what is beyond a wall, or would come in through
/// one.
bool PhotonFollower::sets_out(const SceneHit& hit, PhotonPath& path, PhotonTally& tally) const {
    if (hit.what == What::nothing) return false;
    const glm::dvec2 at(path.way.ray.at(hit.distance_m));
    path.own = hit.what == What::object || hit.what == What::side || domain_.holds(at);
    if (!path.own && domain_.is_beyond_wall(at)) return false;
    if (has_slipped(hit, path.way)) return false;
    count(tally.ledger.incident_w, path.power_w, path.own);
    return true;
}

/// From one boundary on. Whether it goes on.
bool PhotonFollower::step(const SceneHit& hit, PhotonPath& path, PhotonRandom& random, PhotonTally& tally) const {
    FloorLedger& ledger = tally.ledger;
    if (hit.what == What::nothing) {
        const bool up = path.way.ray.direction.z > 0;
        double& row = path.way.inside >= 0 ? ledger.lost_w  // a seam that rounding has opened in glass
                                           : (up ? ledger.reflected_w : ledger.outside_w);
        count(row, path.power_w, path.own);
        return false;
    }
    fade(hit, path, tally);
    if (hit.what == What::floor) {
        land(hit, path, tally);
        return false;
    }
    if (hit.what == What::side) return meet_side(hit, path, tally);
    if (hit.what == What::object && !meet_object(hit, path, tally)) return false;
    if (hit.what == What::water && domain_.is_beyond_wall(glm::dvec2(path.way.ray.at(hit.distance_m)))) {
        count(ledger.outside_w, path.power_w, path.own);
        return false;
    }
    if (path.met++ >= options_.bounces) {
        count(ledger.lost_w, path.power_w, path.own);
        return false;
    }
    return divide(hit, path, random, tally);
}

/// What the medium takes on the way to `hit`.
void PhotonFollower::fade(const SceneHit& hit, PhotonPath& path, PhotonTally& tally) const {
    const double extinction = scene_.extinction_per_m(path.way);
    if (extinction == 0) return;
    const double left_w = path.power_w * f64::beer_lambert(extinction, hit.distance_m);
    count(path.way.inside >= 0 ? tally.ledger.objects_w : tally.ledger.extinguished_w, path.power_w - left_w, path.own);
    path.power_w = left_w;
}

void PhotonFollower::land(const SceneHit& hit, const PhotonPath& path, PhotonTally& tally) const {
    const glm::dvec3 at = path.way.ray.at(hit.distance_m);
    // Where ground ends at a side, light may come in beneath it.
    const bool from_below = glm::dot(path.way.ray.direction, hit.normal) > 0;
    if (from_below || domain_.is_beyond_wall(glm::dvec2(at)) || has_slipped(hit, path.way))
        return count(tally.ledger.outside_w, path.power_w, path.own);
    tally.landings.push_back({at, hit.normal, path.power_w, -1, path.own});
}

/// A wall ends it, a periodic side leads round.
bool PhotonFollower::meet_side(const SceneHit& hit, PhotonPath& path, PhotonTally& tally) const {
    const int axis = hit.side.x != 0 ? 0 : 1;
    if (!domain_.periodic(axis)) {
        count(tally.ledger.outside_w, path.power_w, path.own);
        return false;
    }
    const bool lost = path.round >= most_rounds;
    go_round(hit, path);
    if (!lost && !leaves(path.way)) return true;
    count(lost ? tally.ledger.lost_w : tally.ledger.reflected_w, path.power_w, path.own);
    return false;
}

void PhotonFollower::go_round(const SceneHit& hit, PhotonPath& path) const {
    const int axis = hit.side.x != 0 ? 0 : 1;
    ++path.round;
    path.way = scene_.wrapped(path.way, hit);
    if (!path.way.in_water) path.way.ray.from_m.z -= hit.side[axis] * domain_.climb_m[axis];
}

/// Whether light from the air is on ground with water above it: it came in beside the water, where that ends at a wall
/// or, with a step, at still water.
bool PhotonFollower::has_slipped(const SceneHit& hit, const Traveller& way) const {
    constexpr double film_m = 1e-5;  // as good as dry
    if (hit.what != What::floor || way.in_water) return false;
    return scene_.is_under_water(way.ray.at(hit.distance_m) + glm::dvec3{0, 0, film_m});
}

/// Whether it goes on: from clear glass, and what a mirror sends back.
bool PhotonFollower::meet_object(const SceneHit& hit, PhotonPath& path, PhotonTally& tally) const {
    const Material& material = scene_.objects().object(hit.object).material;
    if (material.type == Material::Type::glass) return true;
    const double kept = material.type == Material::Type::mirror ? material.reflectance : 0;
    count(tally.ledger.objects_w, (1 - kept) * path.power_w, path.own);
    if (material.type == Material::Type::diffuse)
        tally.landings.push_back({path.way.ray.at(hit.distance_m), hit.normal, path.power_w, hit.object, path.own});
    path.power_w *= kept;
    return kept > 0;
}

/// At clear media both ways, or one of them by its share. What is reflected straight out is accounted for at once:
/// that costs nothing and spares the map the noise of it.
bool PhotonFollower::divide(const SceneHit& hit, PhotonPath& path, PhotonRandom& random, PhotonTally& tally) const {
    const Branches ways = scene_.branch(path.way, hit);
    const double through = ways.transmittance, through_w = through * path.power_w;
    const double back_w = path.power_w - through_w;
    path.way = ways.reflected;
    if (through > 0) {
        if (leaves(ways.reflected)) {
            count(tally.ledger.reflected_w, back_w, path.own);
            path.way = ways.refracted;
            path.power_w = through_w;
        } else if (through_w > path.least_w && back_w > path.least_w) {
            path.power_w = back_w;
            tally.waiting.push_back(path);
            path.way = ways.refracted;
            path.power_w = through_w;
        } else if (random.next() < through) {
            path.way = ways.refracted;
        }
    }
    if (!leaves(path.way)) {
        path.way.ray.from_m = domain_.brought_in(path.way.ray.from_m, path.way.in_water);
        return true;
    }
    count(tally.ledger.reflected_w, path.power_w, path.own);
    return false;
}

}  // namespace waterlight
