#include "caustics/splat/light_ways.hpp"

#include <algorithm>
#include <cmath>

namespace waterlight {

namespace {

using What = SceneHit::What;

constexpr double least_part = 1e-3;  // of a vertex's light: ways with less are lost
constexpr int most_wraps = 64;

}  // namespace

LightWays::LightWays(const SplatSettings& settings, const SplatFrame& frame, const WaterScene& scene)
    : bounces_(settings.options.bounces), frame_(frame), scene_(scene), top_m_(scene.highest_water_m()) {
    const glm::dvec3 low = scene.objects().low_m(), high = scene.objects().high_m();
    has_objects_ = low.x <= high.x;
    if (has_objects_) top_m_ = std::max(top_m_, high.z);
    if (settings.bed_m) top_m_ = std::max<double>(top_m_, *std::ranges::max_element(settings.bed_m->values()));
    top_m_ += 1;
}

void LightWays::follow(glm::ivec2 vertex, std::vector<CapturedVertex>& out, FlightAccount& account) {
    vertex_ = vertex;
    out_ = &out;
    account_ = &account;
    const std::optional<Way> first = from_light();
    if (!first) return;
    least_w_ = least_part * first->power_w;
    pending_.assign(1, *first);
    while (!pending_.empty()) {
        const Way way = pending_.back();
        pending_.pop_back();
        go_on(way);
    }
}

bool LightWays::in_domain(glm::dvec2 at) const {
    const Grid& g = scene_.surface().grid;
    return at.x >= g.x0_m && at.x <= g.x0_m + g.width_m() && at.y >= g.y0_m && at.y <= g.y0_m + g.height_m();
}

/// The light of the vertex, through its rectangle in the plane z = 0, if it goes to the domain or to an object.
std::optional<LightWays::Way> LightWays::from_light() {
    const f64::SplatLight& light = frame_.light;
    const glm::dvec3 place{frame_.lattice.place_m(vertex_), 0};
    const f64::LightThere there = f64::light_at(light, place);
    const double power = there.irradiance * std::max(0.0, -there.direction.z) * frame_.lattice.area_m2();
    if (!(power > 0)) return std::nullopt;
    const bool parallel = light.image.parallel == 1;
    const Ray ray{parallel ? f64::ray_at_height(light.image, place, top_m_) : light.image.source, there.direction};
    const auto [from, hit] = first_met(ray);
    if (hit.what == What::nothing || hit.what == What::side) return std::nullopt;
    const bool inside = in_domain(glm::dvec2(from.at(hit.distance_m)));
    // The bare floor beside the water is not ours to light.
    if (hit.what == What::floor && !inside) return std::nullopt;
    own_ = hit.what == What::object || inside;
    count(account_->ledger.incident_w, power);
    // Where it lands goes on evenly from vertex to vertex, over whatever side it comes in.
    return Way{.traveller = {from}, .start_m = ray.from_m, .power_w = power};
}

/// What a ray of the light meets first, and the ray: parallel light also comes in over periodic sides.
std::pair<Ray, SceneHit> LightWays::first_met(const Ray& ray) const {
    std::pair<Ray, SceneHit> best{ray, scene_.first_hit({ray})};
    if (frame_.light.image.parallel == 0) return best;
    const auto counts = [](const SceneHit& hit) { return hit.what == What::water || hit.what == What::object; };
    const int x = frame_.period_m.x > 0 ? 1 : 0, y = frame_.period_m.y > 0 ? 1 : 0;
    for (int b = -y; b <= y; ++b)
        for (int a = -x; a <= x; ++a) {
            if ((a == 0 && b == 0) || (counts(best.second) && !has_objects_)) continue;
            Ray shifted = ray;
            shifted.from_m += glm::dvec3(glm::dvec2(a, b) * frame_.period_m, 0);
            const SceneHit hit = scene_.first_hit({shifted});
            if (counts(hit) && (!counts(best.second) || hit.distance_m < best.second.distance_m)) best = {shifted, hit};
        }
    return best;
}

void LightWays::go_on(const Way& way) {
    const SceneHit hit = scene_.first_hit(way.traveller);
    switch (hit.what) {
        case What::nothing:
            return count(account_->ledger.reflected_w, way.power_w);
        case What::floor:
            return land(way, hit);
        case What::side:
            return pass_side(way, hit);
        case What::water:
        case What::object:
            return meet(way, hit);
    }
}

/// The last part of a way. Floor beside the domain that is met through air alone receives nothing.
void LightWays::land(const Way& way, const SceneHit& hit) {
    const bool beside = own_ && !way.traveller.in_water && !in_domain(glm::dvec2(way.traveller.ray.at(hit.distance_m)));
    if (beside || !(way.traveller.ray.direction.z < 0)) return count(account_->ledger.outside_w, way.power_w);
    out_->push_back(
        {{way.start_m, way.traveller.ray.direction, way.power_w, scene_.extinction_per_m(way.traveller), own_},
         vertex_,
         way.way});
}

void LightWays::pass_side(const Way& way, const SceneHit& hit) {
    const Boundary sides = scene_.surface().boundary;
    const Side side = hit.side.x != 0 ? sides.x : sides.y;
    if (side == Side::wall || way.wraps == most_wraps) {
        const double path = way.travelled_m + hit.distance_m;
        const double left = way.power_w * f64::beer_lambert(scene_.extinction_per_m(way.traveller), path);
        count(account_->ledger.extinguished_w, way.power_w - left);
        return count(side == Side::wall ? account_->ledger.outside_w : account_->ledger.lost_w, left);
    }
    Way on = way;
    on.traveller = scene_.wrapped(way.traveller, hit);
    on.travelled_m += hit.distance_m;
    ++on.wraps;
    pending_.push_back(on);
}

void LightWays::meet(const Way& way, const SceneHit& hit) {
    FloorLedger& ledger = account_->ledger;
    const double path = way.travelled_m + hit.distance_m;
    const double left = way.power_w * f64::beer_lambert(scene_.extinction_per_m(way.traveller), path);
    count(way.traveller.inside >= 0 ? ledger.objects_w : ledger.extinguished_w, way.power_w - left);
    Way on = way;
    on.start_m = way.start_m + path * way.traveller.ray.direction;
    on.travelled_m = 0;
    ++on.met;
    double reflectance = 1;
    if (hit.what == What::object) {
        const Material& material = scene_.objects().object(hit.object).material;
        if (material.type == Material::Type::diffuse) return count(ledger.objects_w, left);
        if (material.type == Material::Type::mirror) reflectance = material.reflectance;
    }
    if (on.met > bounces_) return count(ledger.lost_w, left);
    const Branches ways = scene_.branch(way.traveller, hit);
    count(ledger.objects_w, left * (1 - reflectance));
    branch(on, ways.reflected, left * reflectance * (1 - ways.transmittance), true, hit.object);
    branch(on, ways.refracted, left * ways.transmittance, false, hit.object);
}

void LightWays::branch(const Way& way, const Traveller& on, double power, bool reflected, int object) {
    if (!(power > 0)) return;
    if (power < least_w_) return count(account_->ledger.lost_w, power);
    Way next = way;
    next.traveller = on;
    next.power_w = power;
    next.way = way.way * 0x9E3779B97F4A7C15ULL + 2 * static_cast<std::uint64_t>(object + 2) + (reflected ? 1 : 0);
    pending_.push_back(next);
}

}  // namespace waterlight
