// Ways of sight through the air: to the water of every period, objects, rims and banks, or the sky.
#include <algorithm>
#include <cmath>

#include "render/traced/air_meeting.hpp"
#include "render/traced/tracer.hpp"

namespace waterlight {

namespace {

/// A ray cut at the sides of periods: where it leaves the one in which it is.
class Periods {
  public:
    Periods(const Surface& surface, const Ray& ray)
        : low_{surface.grid.x0_m, surface.grid.y0_m},
          size_{surface.grid.width_m(), surface.grid.height_m()},
          wraps_{surface.boundary.x == Side::periodic, surface.boundary.y == Side::periodic},
          ray_(ray) {}

    /// Of the period at t, its shift from the domain.
    glm::dvec2 shift(double t) const {
        glm::dvec2 shift{0, 0};
        for (int axis = 0; axis < 2; ++axis)
            if (wraps_[axis]) shift[axis] = std::floor((ray_.at(t)[axis] - low_[axis]) / size_[axis]) * size_[axis];
        return shift;
    }
    double end(glm::dvec2 shift) const {
        double t = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 2; ++axis) {
            const double speed = ray_.direction[axis];
            if (!wraps_[axis] || speed == 0) continue;
            const double side = low_[axis] + shift[axis] + (speed > 0 ? size_[axis] : 0);
            t = std::min(t, (side - ray_.from_m[axis]) / speed);
        }
        return t;
    }

  private:
    glm::dvec2 low_, size_;
    glm::bvec2 wraps_;
    const Ray& ray_;
};

}  // namespace

bool Tracer::beyond_walls(glm::dvec3 place) const {
    const SceneParameters& s = text_.s;
    return (text_.wall_x && (place.x < s.x0 || place.x > s.x1)) || (text_.wall_y && (place.y < s.y0 || place.y > s.y1));
}

Tracer::AirMeeting Tracer::meet_in_air(Sight& sight) {
    constexpr int most_periods = 100;
    AirMeeting found;
    const Ray ray = sight.traveller.ray;
    const double top = std::max(water_.highest_water_m(), objects_ ? water_.objects().high_m().z : -1e9) + 1e-3;
    const bool climbs = ray.from_m.z > top && ray.direction.z >= 0;
    double t = ray.from_m.z > top && !climbs ? (top - ray.from_m.z) / ray.direction.z : 0;
    const Periods periods(water_.surface(), ray);
    for (int k = 0; k < most_periods && !climbs; ++k) {
        if (ray.at(t).z > top + 1e-6) break;
        const double small = 1e-9 * (1 + t);
        const glm::dvec2 shift = periods.shift(t + small);
        const double end = periods.end(shift);
        Traveller moved = sight.traveller;
        moved.ray.from_m -= glm::dvec3(shift, 0);
        moved.ray.nearest_m = std::max(moved.ray.nearest_m, t - small);
        moved.ray.farthest_m = end + small;
        SceneHit hit = water_.first_hit(moved);
        moved.ray.farthest_m = ray.farthest_m;
        moved.ray.nearest_m = ray.nearest_m;
        const bool ground = hit.what == SceneHit::What::floor && text_.uneven;
        const bool water = hit.what == SceneHit::What::water && !beyond_walls(moved.ray.at(hit.distance_m));
        if (ground || water || hit.what == SceneHit::What::object) {
            found = {ground ? AirMeeting::What::ground : (water ? AirMeeting::What::water : AirMeeting::What::object),
                     hit.distance_m, -1, hit};
            sight.traveller = moved;
            break;
        }
        if (!std::isfinite(end)) break;
        t = end;
    }
    const bool open = !text_.wall_x || !text_.wall_y;
    if (found.what == AirMeeting::What::sky && open && ray.direction.z < 0 && !sight.off_water) {
        const double far = -ray.from_m.z / ray.direction.z;
        if (far > t && !beyond_walls(ray.at(far))) found = {AirMeeting::What::water, far, -1, {}};
    }
    meet_dry(sight, found);
    return found;
}

/// Walls above the water, seen from within, and the deck, from above.
void Tracer::meet_dry(const Sight& sight, AirMeeting& nearest) const {
    const Ray& ray = sight.traveller.ray;
    const SceneParameters& s = text_.s;
    const auto offer = [&](AirMeeting::What what, double t, int wall) {
        if (t > ray.nearest_m && t < nearest.way) nearest = {what, t, wall, {}};
    };
    for (int wall = 0; wall < 4; ++wall) {
        const int axis = wall / 2;
        if (!(axis == 0 ? text_.wall_x : text_.wall_y)) continue;
        const double outwards = wall % 2 == 0 ? -1 : 1;
        if (outwards * ray.direction[axis] <= 0) continue;
        const double side = wall == 0 ? s.x0 : (wall == 1 ? s.x1 : (wall == 2 ? s.y0 : s.y1));
        const double t = (side - ray.from_m[axis]) / ray.direction[axis];
        const glm::dvec3 place = ray.at(t);
        const bool along = axis == 0 ? !text_.wall_y || (place.y >= s.y0 && place.y <= s.y1)
                                     : !text_.wall_x || (place.x >= s.x0 && place.x <= s.x1);
        if (along && place.z <= s.freeboard && place.z >= -s.depth) offer(AirMeeting::What::wall, t, wall);
    }
    if (!(text_.wall_x || text_.wall_y) || ray.direction.z >= 0) return;
    const double t = (s.freeboard - ray.from_m.z) / ray.direction.z;
    if (beyond_walls(ray.at(t))) offer(AirMeeting::What::deck, t, -1);
}

glm::dvec3 Tracer::at_dry(const Sight& sight, const AirMeeting& m) {
    const glm::dvec3 place = sight.traveller.ray.at(m.way), d = sight.traveller.ray.direction;
    const glm::vec3 at(place);
    const double width = sight.width_at(m.way);
    const auto widths = [&](glm::dvec3 normal) {
        return glm::vec2(static_cast<float>(width / std::sqrt(std::max(0.02, std::abs(glm::dot(d, normal))))));
    };
    const auto lit = static_cast<float>(sun_left(place));
    const auto lamp = [&](glm::dvec3 normal, glm::vec3 albedo) {
        return from_lamp(place, normal, false) * glm::dvec3(albedo) * (1 / static_cast<double>(text_.pi));
    };
    const SceneParameters& s = text_.s;
    if (m.what == AirMeeting::What::wall) {
        const glm::dvec3 normal(text_.wall_inward(m.wall));
        return glm::dvec3(text_.dry_wall(m.wall, at, widths(normal), lit)) +
               lamp(normal, {s.wall_r, s.wall_g, s.wall_b});
    }
    const glm::dvec3 up{0, 0, 1};
    if (m.what == AirMeeting::What::deck)
        return glm::dvec3(text_.deck(at, widths(up), lit)) + lamp(up, {s.deck_r, s.deck_g, s.deck_b});
    const auto ground = text_.ground_around(text_.cells_of(glm::vec2(at)));
    const glm::dvec3 normal(f32::normal_of(ground.slope));
    return glm::dvec3(text_.dry_ground(at, ground.slope, widths(up), lit)) +
           lamp(normal, {s.mean_r, s.mean_g, s.mean_b});
}

glm::dvec3 Tracer::in_air(const Sight& sight) {
    Sight here = sight;
    const AirMeeting m = meet_in_air(here);
    switch (m.what) {
        case AirMeeting::What::sky:
            return sky(here);
        case AirMeeting::What::water:
            return at_water_from_above(here, m.way);
        case AirMeeting::What::object:
            return at_object(here, m.hit);
        default:
            return at_dry(here, m);
    }
}

}  // namespace waterlight
