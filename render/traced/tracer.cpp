#include "render/traced/tracer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/scene_light.hpp"

namespace waterlight {

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

struct Tracer::WaterPoint {
    glm::vec2 slope{0, 0};
    float variance = 0;
};

Tracer::Tracer(const TracedScene& scene, const WaterScene& water, const SceneData& data, const TraceOptions& options)
    : scene_(scene),
      water_(water),
      options_(options),
      text_(data.text()),
      things_(data.things_text()),
      levels_(data.surface()),
      objects_(scene.objects && !scene.objects->empty()) {}

glm::dvec3 Tracer::seen_at(glm::dvec2 pixel, double part, unsigned seed) {
    const f32::SceneText::Sight a = text_.sight(glm::vec2(pixel) + 0.5F);
    Sight sight;
    sight.seed = seed;
    sight.spread = part * text_.pixel_width() / a.metres;
    const glm::dvec3 direction = glm::normalize(glm::dvec3(a.d));
    const double entry = text_.outside ? text_.entry_way(a.d) : 0;
    sight.traveller.ray = {glm::dvec3(text_.eye()) + entry * direction, direction};
    sight.width_m = entry * sight.spread;
    sight.traveller.in_water = text_.in_water && !beyond_walls(sight.traveller.ray.at(1e-6));
    const auto first = objects_ ? water_.objects().first_hit(sight.traveller.ray) : std::nullopt;
    if (first && !first->enters(sight.traveller.ray)) sight.traveller.inside = first->object;
    if (text_.beams == nullptr) return radiance(sight);
    return radiance(sight) + glm::dvec3(text_.beam_light(glm::vec2(pixel) + 0.5F) * text_.beam_tint(a));
}

glm::dvec3 Tracer::radiance(const Sight& sight) {
    if (sight.met > options_.bounces || sight.share < options_.least_share) return even(sight);
    if (sight.traveller.inside >= 0) return in_glass(sight);
    return sight.traveller.in_water ? in_water(sight) : in_air(sight);
}

double Tracer::index_of(const Traveller& t) const {
    if (t.inside >= 0) return water_.objects().object(t.inside).material.index_at(scene_.wavelength_nm);
    return t.in_water ? scene_.scene.optics.refractive_index : 1;
}

glm::dvec3 Tracer::even(const Sight& sight) const {
    const double n = index_of(sight.traveller);
    return glm::dvec3(text_.s.sky_r, text_.s.sky_g, text_.s.sky_b) * (n * n / pi);
}

glm::dvec3 Tracer::in_glass(const Sight& sight) {
    const SceneHit hit = water_.first_hit(sight.traveller);
    // Rounding at an edge can let a way out where there is no wall.
    if (hit.what != SceneHit::What::object) return even(sight);
    return at_object(sight, hit) * std::exp(-water_.extinction_per_m(sight.traveller) * hit.distance_m);
}

glm::dvec3 Tracer::in_water(const Sight& sight) {
    constexpr int most_periods = 64;
    const Boundary& sides = water_.surface().boundary;
    Sight here = sight;
    SceneHit hit = water_.first_hit(here.traveller);
    double way = hit.distance_m;
    for (int k = 0; k < most_periods && hit.what == SceneHit::What::side; ++k) {
        if ((hit.side.x != 0 ? sides.x : sides.y) != Side::periodic) break;
        here.traveller = water_.wrapped(here.traveller, hit);
        here.width_m += hit.distance_m * here.spread;
        hit = water_.first_hit(here.traveller);
        way += hit.distance_m;
    }
    const Ray& ray = sight.traveller.ray;
    glm::dvec3 seen{0, 0, 0};
    const bool up = ray.direction.z > 0 && ray.from_m.z <= 0;
    if (hit.what == SceneHit::What::object) {
        seen = at_object(here, hit);
    } else if (hit.what == SceneHit::What::water) {
        seen = at_water_from_below(here, hit.distance_m);
    } else if (hit.what == SceneHit::What::nothing && up) {  // still water beyond
        way = -ray.from_m.z / ray.direction.z;
        seen = at_water_from_below(sight, way);
    } else {
        seen = at_bottom(sight, way);
    }
    const glm::vec3 from(ray.from_m), d(ray.direction);
    seen *= glm::exp(-glm::dvec3(text_.sight_extinction()) * way);
    const bool in_beams = sight.met == 0 && text_.beams != nullptr;
    return in_beams ? seen : seen + glm::dvec3(text_.scattered(from, d, static_cast<float>(way)));
}

/// Floor, ground or wall below the water; sets how far it is.
glm::dvec3 Tracer::at_bottom(const Sight& sight, double& way) {
    const glm::vec3 from(sight.traveller.ray.from_m);
    glm::vec3 d(sight.traveller.ray.direction);
    d.z = std::min(d.z, text_.wall_x || text_.wall_y ? d.z : -0.003F);
    const f32::SceneText::Meeting m = text_.meet(from, d);
    way = m.way;
    const glm::vec3 place = from + m.way * d;
    const glm::dvec3 normal = m.wall < 0 ? glm::dvec3(0, 0, 1) : glm::dvec3(text_.wall_inward(m.wall));
    const double width = sight.width_at(way), slant = std::max(0.02, std::abs(glm::dot(glm::dvec3(d), normal)));
    const double open = open_part(glm::dvec3(place), normal, sight.seed);
    return text_.radiance_in_water(m.wall, place, static_cast<float>(width),
                                   glm::vec2(static_cast<float>(width / std::sqrt(slant))), static_cast<float>(open));
}

Tracer::WaterPoint Tracer::water_point(glm::dvec3 place, glm::dvec3 d, double width) {
    const double slant = std::max(0.02, std::abs(d.z));
    const double cells = width / std::sqrt(slant) / text_.s.cell_x;
    const int last = static_cast<int>(levels_.levels.size()) - 1;
    const int k = std::clamp(static_cast<int>(std::floor(std::log2(std::max(cells, 1.0)))), 0, last);
    const glm::vec2 at(place);
    const auto far = [](bool wraps, float x, float low, float high) { return !wraps && (x < low || x > high); };
    const bool beyond =
        far(text_.wraps_x, at.x, text_.s.x0, text_.s.x1) || far(text_.wraps_y, at.y, text_.s.y0, text_.s.y1);
    const SurfaceLevel& level = beyond ? levels_.beyond : levels_.levels[static_cast<std::size_t>(k)];
    text_.coarse = beyond || k > 0;
    text_.p.level_offset = level.offset;
    text_.p.level_nx = level.nx;
    text_.p.level_ny = level.ny;
    text_.p.level_scale = level.scale;
    const double across = std::hypot(d.x, d.y);
    const glm::vec2 ahead = across > 1e-4 ? glm::vec2(d.x / across, d.y / across) : glm::vec2(1, 0);
    const auto half = static_cast<float>(0.5 * width);
    const auto slopes =
        text_.slopes_at(text_.cells_around(text_.cells_of(at)), ahead * (half / static_cast<float>(slant)),
                        glm::vec2(-ahead.y, ahead.x) * half);
    return {slopes.mean, slopes.variance};
}

glm::dvec3 Tracer::at_water_from_above(const Sight& sight, double way) {
    const glm::dvec3 place = sight.traveller.ray.at(way);
    const glm::vec3 d(sight.traveller.ray.direction);
    const double width = sight.width_at(way);
    const WaterPoint q = water_point(place, sight.traveller.ray.direction, width);
    const glm::vec3 normal = f32::normal_of(f32::visible_slope(-d, q.slope, q.variance, 1));
    const f32::RayRefraction refracted = f32::refract_ray(d, normal, text_.s.index, text_.s.fresnel);
    const double n2 = text_.s.index * text_.s.index, through = refracted.transmittance;
    Sight next = sight;
    next.width_m = width;
    next.met = sight.met + 1;
    next.off_water = true;
    next.share = sight.share * through;
    next.spread = sight.spread / text_.s.index;
    next.traveller = {{place, glm::normalize(glm::dvec3(refracted.direction))}, true, -1};
    glm::dvec3 seen = through / n2 * radiance(next);
    next.share = sight.share * (1 - through);
    next.spread = sight.spread;
    next.traveller = {{place, glm::normalize(glm::dvec3(f32::reflect_ray(d, normal)))}, false, -1};
    if (through < 1) seen += (1 - through) * radiance(next);
    const double glint = text_.glint(d, q.slope, q.variance);
    return glint > 0 ? seen + glint * sun_left(place) : seen;
}

glm::dvec3 Tracer::at_water_from_below(const Sight& sight, double way) {
    const glm::dvec3 place = sight.traveller.ray.at(way);
    const glm::vec3 d(sight.traveller.ray.direction);
    const double width = sight.width_at(way);
    const WaterPoint q = water_point(place, sight.traveller.ray.direction, width);
    const glm::vec3 normal = -f32::normal_of(f32::visible_slope(-d, q.slope, q.variance, -1));
    const f32::RayRefraction refracted = f32::refract_ray(d, normal, 1 / text_.s.index, text_.s.fresnel);
    const double n2 = text_.s.index * text_.s.index, through = refracted.transmittance;
    Sight next = sight;
    next.width_m = width;
    next.met = sight.met + 1;
    next.off_water = true;
    next.share = sight.share * through;
    next.spread = sight.spread * text_.s.index;
    next.traveller = {{place, glm::normalize(glm::dvec3(refracted.direction))}, false, -1};
    glm::dvec3 seen{0, 0, 0};
    if (through > 0) seen += n2 * through * radiance(next);
    glm::dvec3 mirrored(f32::reflect_ray(d, normal));
    mirrored.z = std::min(mirrored.z, -0.003);
    next.share = sight.share * (1 - through);
    next.spread = sight.spread;
    next.traveller = {{place, glm::normalize(mirrored)}, true, -1};
    if (through < 1) seen += (1 - through) * radiance(next);
    const double shine = n2 * text_.shine(d, q.slope, q.variance);
    return shine > 0 ? seen + shine * sun_left(place) : seen;
}

/// The sun's disc is spread over the cone where that is wider.
glm::dvec3 Tracer::sky(const Sight& sight) {
    const glm::dvec3 d = sight.traveller.ray.direction;
    const glm::vec3 from(d);
    if (sight.off_water) return text_.sky_above(from);
    glm::dvec3 seen = text_.sky_at(from);
    const glm::dvec3 to_sun = -scene_.scene.sun.direction();
    if (d.z <= 0 || glm::dot(d, to_sun) <= 0) return seen;
    const double half = sight.spread, radius = std::max<double>(text_.s.sun_radius, half);
    const double off = glm::length(glm::cross(d, to_sun));
    const double part = std::clamp(0.5 + (radius - off) / std::max(2 * half, 1e-9), 0.0, 1.0);
    // Its edge, from radius - half to radius + half, is a slope: so much larger is the disc.
    if (part > 0) seen += part * text_.s.sun_irradiance / (pi * (radius * radius + half * half / 3));
    return seen;
}

}  // namespace waterlight
