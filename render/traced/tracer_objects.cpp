// Objects as they are seen: glass, mirrors, and diffuse ones with the light on them.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "caustics/kernels/optics.hpp"
#include "render/traced/tracer.hpp"

namespace waterlight {

namespace {

constexpr double pi = std::numbers::pi;

/// A number in [0, 1) for each pair.
double fraction(unsigned seed, unsigned k) {
    unsigned x = seed * 0x9E3779B1U + k * 0x85EBCA77U + 0x27D4EB2FU;
    x = (x ^ (x >> 15)) * 0x2C1B3C6DU;
    x = (x ^ (x >> 12)) * 0x297A2D39U;
    return (x ^ (x >> 15)) * (1.0 / 4294967296.0);
}

/// Per metre, of the side that faces away from the axis by `along`, the axis' part of the normal; flat ends have none.
struct CurvatureOf {
    double along;
    bool flat() const { return std::abs(along) > 0.9; }
    double operator()(const Sphere& s) const { return 1 / s.radius_m; }
    double operator()(const Box&) const { return 0; }
    double operator()(const Ring& r) const { return flat() ? 0 : 1 / r.outer_radius_m; }
    double operator()(const Cup& c) const { return flat() ? 0 : 2 / (c.bottom_radius_m + c.top_radius_m); }
    double operator()(const Mesh&) const { return 0; }
};

}  // namespace

/// How much the normal turns per metre: it widens the cone.
double Tracer::curvature(const SceneHit& hit) const {
    const Object& object = water_.objects().object(hit.object);
    return std::visit(CurvatureOf{glm::dot(object.turn()[2], hit.normal)}, object.shape);
}

glm::dvec3 Tracer::at_object(const Sight& sight, const SceneHit& hit) {
    const Material& material = water_.objects().object(hit.object).material;
    if (material.type == Material::Type::diffuse) return at_diffuse(sight, hit);
    if (material.type == Material::Type::glass) return at_glass(sight, hit);
    Sight next = sight;
    next.traveller = water_.branch(sight.traveller, hit).reflected;
    next.width_m = sight.width_at(hit.distance_m);
    next.spread = sight.spread + 2 * curvature(hit) * next.width_m;
    next.share = sight.share * material.reflectance;
    next.met = sight.met + 1;
    next.off_water = false;
    return material.reflectance * radiance(next);
}

/// Radiance over the square of the index is what refraction keeps.
glm::dvec3 Tracer::at_glass(const Sight& sight, const SceneHit& hit) {
    const Branches ways = water_.branch(sight.traveller, hit);
    const double through = ways.transmittance, turn = curvature(hit);
    Sight next = sight;
    next.width_m = sight.width_at(hit.distance_m);
    next.met = sight.met + 1;
    next.off_water = false;
    glm::dvec3 seen{0, 0, 0};
    if (through > 0) {
        const double n = index_of(sight.traveller) / index_of(ways.refracted);
        next.traveller = ways.refracted;
        next.share = sight.share * through;
        next.spread = sight.spread * n + std::abs(1 - n) * turn * next.width_m;
        seen += through * n * n * radiance(next);
    }
    if (through < 1) {
        next.traveller = ways.reflected;
        next.share = sight.share * (1 - through);
        next.spread = sight.spread + 2 * turn * next.width_m;
        seen += (1 - through) * radiance(next);
    }
    return seen;
}

glm::dvec3 Tracer::at_diffuse(const Sight& sight, const SceneHit& hit) {
    const Traveller& t = sight.traveller;
    const glm::dvec3 place = t.ray.at(hit.distance_m);
    // Within glass, as a thing frozen into it, by the light around the glass.
    const bool in_water = t.inside >= 0 ? water_.is_under_water(place) : t.in_water;
    const glm::dvec3 normal = glm::dot(t.ray.direction, hit.normal) < 0 ? hit.normal : -hit.normal;
    const glm::dvec3 irradiance =
        direct(place, normal, in_water) + open_part(place, normal, sight.seed) * diffuse(place, normal, in_water);
    return irradiance * (water_.objects().object(hit.object).material.reflectance / pi);
}

glm::dvec3 Tracer::direct(glm::dvec3 place, glm::dvec3 normal, bool in_water) {
    glm::dvec3 sum = from_lamp(place, normal, in_water);
    if (!(text_.s.sun_irradiance > 0)) return sum;
    if (in_water) return sum + sun_in_water(place, normal);
    const double facing = glm::dot(normal, -scene_.scene.sun.direction());
    return facing > 0 ? sum + glm::dvec3(text_.s.sun_irradiance * facing * sun_left(place)) : sum;
}

/// Across its beam calm water's light is as much more than on the horizontal plane as its way is longer than its
/// descent. Under waves that light is read from the volume; its direction is taken for that of calm water.
glm::dvec3 Tracer::sun_in_water(glm::dvec3 place, glm::dvec3 normal) {
    const double path = text_.s.path, depth = std::max(0.0, -place.z);
    const glm::dvec3 to_light = glm::dvec3(-text_.s.travel_x, -text_.s.travel_y, 1) / path;
    const double facing = glm::dot(normal, to_light);
    if (facing <= 0) return {0, 0, 0};
    const double below = left_by_objects(place, to_light, depth * path, true);
    if (below <= 0) return {0, 0, 0};
    const double left = below * sun_left(place + depth * path * to_light);
    const glm::vec3 at(place);
    if (things_) {
        const glm::dvec3 colour(glm::exp(-text_.colours() * static_cast<float>(path * depth)));
        return colour * (things_->volume_at(at) * facing * left);
    }
    return glm::dvec3(text_.calm_sun(glm::vec2(at), static_cast<float>(depth))) * (path * facing * left);
}

glm::dvec3 Tracer::from_lamp(glm::dvec3 place, glm::dvec3 normal, bool in_water) {
    if (!scene_.lamp) return {0, 0, 0};
    const glm::dvec3 off = scene_.lamp->at_m - place;
    const double way = glm::length(off);
    const glm::dvec3 to_lamp = off / way;
    const double facing = glm::dot(normal, to_lamp);
    if (facing <= 0 || !scene_.lamp->lights(-to_lamp)) return {0, 0, 0};
    double left = left_by_objects(place, to_lamp, way, in_water);
    glm::dvec3 colour(1);
    if (in_water && to_lamp.z > 0) {
        const double under = std::min(way, std::max(0.0, -place.z) / to_lamp.z);
        const glm::dvec3 absorbed{text_.s.colour_r, text_.s.colour_g, text_.s.colour_b};
        colour = glm::exp(-(absorbed + static_cast<double>(text_.s.extinction)) * under);
        if (under < way) left *= text_.sun_transmittance(static_cast<float>(to_lamp.z));
    }
    return colour * (scene_.lamp->intensity_w_sr / (way * way) * facing * left);
}

glm::dvec3 Tracer::diffuse(glm::dvec3 place, glm::dvec3 normal, bool in_water) {
    const auto sky_part = static_cast<float>(0.5 * (1 + normal.z));
    if (in_water) return text_.ambient_facing(std::max(0.0F, static_cast<float>(-place.z)), sky_part);
    const glm::vec3 below = beyond_walls(place) ? text_.irradiance_from_ground() : text_.irradiance_from_water();
    return sky_part * text_.sky_irradiance() + (1 - sky_part) * below;
}

/// What keeps diffuse light off sends back its reflectance's part of as much, and glass lets it through: where nothing
/// absorbs, a white furnace stays white.
double Tracer::open_part(glm::dvec3 place, glm::dvec3 normal, unsigned seed) const {
    if (!objects_) return 1;
    // From afar objects keep nothing off.
    const glm::dvec3 low = water_.objects().low_m(), high = water_.objects().high_m();
    const double reach = glm::length(high - low);
    if (glm::length(glm::clamp(place, low, high) - place) > reach) return 1;
    constexpr unsigned rings = 2, sectors = 4;
    const glm::dvec3 side = glm::normalize(std::abs(normal.z) < 0.9 ? glm::cross(normal, glm::dvec3(0, 0, 1))
                                                                    : glm::cross(normal, glm::dvec3(1, 0, 0)));
    const glm::dvec3 other = glm::cross(normal, side);
    double sum = 0;
    for (unsigned k = 0; k < rings * sectors; ++k) {
        const double square = (k / sectors + fraction(seed, 2 * k)) / rings;
        const double turn = 2 * pi * (k % sectors + fraction(seed, 2 * k + 1)) / sectors;
        const double out = std::sqrt(square);
        const glm::dvec3 d = out * (std::cos(turn) * side + std::sin(turn) * other) + std::sqrt(1 - square) * normal;
        sum += diffuse_along({place, d, 1e-6, reach});
    }
    return sum / (rings * sectors);
}

double Tracer::diffuse_along(Ray ray) const {
    constexpr int most_walls = 64;
    double left = 1, entered = 0;
    for (int k = 0; k < most_walls; ++k) {
        const auto hit = water_.objects().first_hit(ray);
        if (!hit) return left;
        const Material& m = water_.objects().object(hit->object).material;
        if (m.type != Material::Type::glass) return left * m.reflectance;
        if (hit->enters(ray))
            entered = hit->distance_m;
        else
            left *= std::exp(-m.absorption_per_m * (hit->distance_m - entered));
        ray.nearest_m = hit->distance_m + 1e-6;
    }
    return left;
}

double Tracer::left_by_objects(glm::dvec3 from, glm::dvec3 direction, double way, bool in_water) const {
    if (!objects_) return 1;
    constexpr int most_walls = 64;
    const double outside = in_water ? scene_.scene.optics.refractive_index : 1;
    Ray ray{from, direction, 1e-6, way};
    double left = 1, entered = 0;
    for (int k = 0; k < most_walls && left > 1e-3; ++k) {
        const auto hit = water_.objects().first_hit(ray);
        if (!hit) return left;
        const Material& m = water_.objects().object(hit->object).material;
        if (m.type != Material::Type::glass) return 0;
        const double n = m.index_at(scene_.wavelength_nm) / outside, cos_i = std::abs(glm::dot(direction, hit->normal));
        const double cos2_t = 1 - (1 - cos_i * cos_i) / (n * n);
        left *= cos2_t > 0 ? f64::fresnel_transmittance(cos_i, std::sqrt(cos2_t), n) : 0;
        if (hit->enters(ray))
            entered = hit->distance_m;
        else
            left *= std::exp(-m.absorption_per_m * (hit->distance_m - entered));
        ray.nearest_m = hit->distance_m + 1e-6;
    }
    return left;
}

double Tracer::sun_left(glm::dvec3 place) const {
    if (!(text_.s.sun_irradiance > 0)) return 0;
    return left_by_objects(place, -scene_.scene.sun.direction(), std::numeric_limits<double>::infinity(), false);
}

}  // namespace waterlight
