#include "caustics/photons/photon_starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "caustics/kernels/optics.hpp"
#include "caustics/surface_point.hpp"

namespace waterlight {

namespace {

constexpr double pi = std::numbers::pi;

LevelBox box_of(const Grid& g) { return {{g.x0_m, g.y0_m}, {g.x0_m + g.width_m(), g.y0_m + g.height_m()}}; }

std::array<glm::dvec2, 4> corners(const LevelBox& box) {
    return {box.low_m, glm::dvec2{box.high_m.x, box.low_m.y}, box.high_m, glm::dvec2{box.low_m.x, box.high_m.y}};
}

LevelBox box_of(const FloorPlan& plan) {
    LevelBox box{plan.position_m({0, 0}), plan.position_m({0, 0})};
    for (const glm::dvec2 pixel : corners({{0, 0}, {plan.width, plan.height}})) box.hold(plan.position_m(pixel));
    return box;
}

double least(const Field<float>& field) { return *std::ranges::min_element(field.values()); }
double most(const Field<float>& field) { return *std::ranges::max_element(field.values()); }

/// The sun's irradiance of a level plane is `irradiance` times the incident factor of its slope.
struct SunLight {
    glm::dvec3 along{0, 0, -1};
    double irradiance = 0;

    explicit SunLight(const Sun& sun) : along(sun.direction()), irradiance(sun.irradiance_w_m2) {}
};

/// The light's image of the sun: the mean plane of the water along its rays. By a whole period the image comes again,
/// climb included, so that of a periodic side it is one period.
class SunImage final : public PhotonStarts {
  public:
    SunImage(const PhotonSettings& settings, const WaterScene& scene) : sun_(settings.floor.sun) {
        const Surface& surface = scene.surface();
        const PhotonDomain domain(surface);
        for (int axis = 0; axis < 2; ++axis) slope_[axis] = domain.periodic(axis) ? surface.tilt[axis] : 0;
        origin_ = domain.low_m;
        factor_ = f64::incident_factor(sun_.along, slope_);
        if (factor_ <= 0) return;
        const LevelBox own = box_of(surface.grid), water = lit_water(settings, surface);
        window_ = water;
        const auto [low, high] = heights(settings, surface);
        for (const glm::dvec2 corner : corners(own))
            for (const double height : {low, high}) hold({corner, plane_m(corner) + height});
        top_m_ = high;
        const glm::dvec3 a = scene.objects().low_m(), b = scene.objects().high_m();
        if (a.z <= b.z)
            for (const glm::dvec2 corner : corners({glm::dvec2(a), glm::dvec2(b)}))
                for (const double z : {a.z, b.z}) hold({corner, z});
        for (int axis = 0; axis < 2; ++axis)
            if (domain.periodic(axis)) {
                window_.low_m[axis] = own.low_m[axis];
                window_.high_m[axis] = own.high_m[axis];
            }
        top_m_ += 1e-3 * (1 + std::abs(top_m_));
    }

    Photon start(glm::dvec2 place) const override {
        const glm::dvec2 size = window_.size_m(), at = window_.low_m + place * size;
        if (factor_ <= 0) return {};
        const glm::dvec3 from = glm::dvec3(at, plane_m(at)) - top_m_ / factor_ * sun_.along;
        return {{{from, sun_.along, 0}}, sun_.irradiance * factor_ * size.x * size.y};
    }

  private:
    double plane_m(glm::dvec2 at) const { return glm::dot(slope_, at - origin_); }

    /// Least and largest height of water and dry ground above the mean plane.
    std::pair<double, double> heights(const PhotonSettings& settings, const Surface& surface) const {
        const Grid& g = surface.grid;
        double low = 0, high = 0;
        for (int j = 0; j < g.ny; ++j)
            for (int i = 0; i < g.nx; ++i) {
                const double plane = plane_m({g.x_m(i), g.y_m(j)}), water = surface.elevation(i, j) - plane;
                low = std::min(low, water);
                high = std::max(high, settings.bed_m ? std::max(water, (*settings.bed_m)(i, j) - plane) : water);
            }
        // The sides lie half a cell beyond the last cells' centres.
        const double beyond = std::abs(slope_.x) * g.dx_m + std::abs(slope_.y) * g.dy_m;
        return {low - beyond, high + beyond};
    }

    /// Widens the window, and raises the top, by a place that the light is to meet.
    void hold(glm::dvec3 at) {
        const double height = at.z - plane_m(glm::dvec2(at));
        window_.hold(glm::dvec2(at + height / factor_ * sun_.along));
        top_m_ = std::max(top_m_, height);
    }

    SunLight sun_;
    glm::dvec2 slope_{0, 0}, origin_{0, 0};  ///< of the mean plane
    double factor_ = 0;
    LevelBox window_;
    double top_m_ = 0;  ///< above the mean plane
};

/// The unit square on the unit disc, areas in proportion (Shirley & Chiu, "A Low Distortion Map Between Disk and
/// Square", 1997).
glm::dvec2 on_disc(glm::dvec2 place) {
    const glm::dvec2 p = 2.0 * place - 1.0;
    if (p.x == 0 && p.y == 0) return {0, 0};
    const bool wide = std::abs(p.x) > std::abs(p.y);
    const double r = wide ? p.x : p.y, angle = wide ? pi / 4 * (p.y / p.x) : pi / 2 - pi / 4 * (p.x / p.y);
    return {r * std::cos(angle), r * std::sin(angle)};
}

/// The light's image of a lamp: a cone about its axis, in cells of equal solid angle. Of a point source the cone opens
/// downwards as far as there is anything to light.
class LampImage final : public PhotonStarts {
  public:
    LampImage(const PhotonSettings& settings, const WaterScene& scene) : lamp_(*settings.lamp) {
        in_water_ = scene.is_under_water(lamp_.at_m);
        if (lamp_.type == Lamp::Type::spot) {
            axis_ = glm::normalize(lamp_.towards_m - lamp_.at_m);
            cosine_ = std::cos(lamp_.half_angle_deg * pi / 180);
        } else {
            cosine_ = reach(settings, scene);
        }
        const glm::dvec3 other = std::abs(axis_.z) < 0.9 ? glm::dvec3{0, 0, 1} : glm::dvec3{1, 0, 0};
        right_ = glm::normalize(glm::cross(axis_, other));
        up_ = glm::cross(right_, axis_);
    }

    Photon start(glm::dvec2 place) const override {
        // Equal areas on the disc are equal solid angles where r^2 is (1 - cos) over its largest.
        const glm::dvec2 disc = on_disc(place);
        const double less = glm::dot(disc, disc) * (1 - cosine_);
        const glm::dvec2 across = std::sqrt((1 - cosine_) * std::max(0.0, 2 - less)) * disc;
        const glm::dvec3 direction = glm::normalize((1 - less) * axis_ + across.x * right_ + across.y * up_);
        return {{{lamp_.at_m, direction, 0}, in_water_}, lamp_.intensity_w_sr * 2 * pi * (1 - cosine_)};
    }

  private:
    /// Least cosine from straight down at which a point source meets anything.
    double reach(const PhotonSettings& settings, const WaterScene& scene) const {
        const PhotonDomain domain(scene.surface());
        const double climb = std::abs(domain.climb_m.x) + std::abs(domain.climb_m.y);
        double top = std::max(scene.highest_water_m(), climb);
        if (settings.bed_m) top = std::max(top, most(*settings.bed_m));
        LevelBox box = lit_water(settings, scene.surface());
        const glm::dvec3 low = scene.objects().low_m(), high = scene.objects().high_m();
        if (low.z <= high.z) {
            box.hold(glm::dvec2(low));
            box.hold(glm::dvec2(high));
            top = std::max(top, high.z);
        }
        const double above = lamp_.at_m.z - top;
        if (above <= 0) return -1;
        if (domain.periodic(0) || domain.periodic(1)) return climb > 0 ? -1 : 0;
        double far = 0;
        for (const glm::dvec2 corner : corners(box)) far = std::max(far, glm::distance(corner, glm::dvec2(lamp_.at_m)));
        return 0.999 * above / std::hypot(above, far);
    }

    Lamp lamp_;
    bool in_water_ = false;
    glm::dvec3 axis_{0, 0, -1}, right_{1, 0, 0}, up_{0, 1, 0};
    double cosine_ = -1;  ///< of the half-angle of the cone
};

/// The water's surface under the sun.
class SurfaceStarts final : public PhotonStarts {
  public:
    SurfaceStarts(const PhotonSettings& settings, const WaterScene& scene)
        : sun_(settings.floor.sun), scene_(scene), window_(lit_water(settings, scene.surface())) {
        dry_ = settings.bed_m && most(*settings.bed_m) >= least(scene.surface().elevation);
    }

    Photon start(glm::dvec2 place) const override {
        const glm::dvec2 size = window_.size_m(), at = window_.low_m + place * size;
        const SurfacePoint water = scene_.surface_at(at);
        const double power = sun_.irradiance * f64::incident_factor(sun_.along, water.slope) * size.x * size.y;
        Photon photon{{{{at, water.elevation_m}, sun_.along}}, power};
        photon.first = SceneHit{SceneHit::What::water, 0, glm::normalize(glm::dvec3(-water.slope, 1)), -1, {0, 0}};
        if (dry_) start_on_ground(photon);
        photon.blocked = scene_.objects().first_hit({photon.way.ray.from_m, -sun_.along}).has_value();
        return photon;
    }

  private:
    void start_on_ground(Photon& photon) const {
        Traveller down;
        down.ray.from_m = photon.way.ray.from_m;
        down.ray.from_m.z = std::max(scene_.highest_water_m(), most(*scene_.settings().bed_m)) + 1;
        const SceneHit hit = scene_.first_hit(down);
        if (hit.what != SceneHit::What::floor) return;
        photon.way.ray.from_m = down.ray.at(hit.distance_m);
        photon.first = hit;
        photon.first->distance_m = 0;
    }

    SunLight sun_;
    const WaterScene& scene_;
    LevelBox window_;
    bool dry_ = false;
};

}  // namespace

LevelBox lit_water(const PhotonSettings& settings, const Surface& surface) {
    LevelBox water = box_of(surface.grid);
    const LevelBox map = box_of(settings.floor.plan);
    LevelBox wide = water;
    if (settings.lamp) {
        for (const glm::dvec2 at : {map.low_m, map.high_m, glm::dvec2(settings.lamp->at_m)}) wide.hold(at);
    } else {
        const double depth = settings.bed_m ? -least(*settings.bed_m) : settings.floor.depth_m;
        const WaterOptics& optics = settings.floor.optics;
        const glm::dvec2 travel =
            f64::refract_sun(settings.floor.sun.direction(), {0, 0}, optics.refractive_index, 1).travel;
        // Ground is nowhere deeper; where it is less deep the light has come less far.
        for (const double d : {settings.bed_m ? 0 : depth, depth})
            for (const glm::dvec2 at : {map.low_m, map.high_m}) wide.hold(at - std::max(0.0, d) * travel);
    }
    const PhotonDomain domain(surface);
    for (int axis = 0; axis < 2; ++axis) {
        if (domain.side(axis) != Side::absorbing) continue;
        water.low_m[axis] = wide.low_m[axis];
        water.high_m[axis] = wide.high_m[axis];
    }
    return water;
}

bool starts_on_surface(const PhotonSettings& settings, const Surface& surface, const PlacedObjects& objects) {
    if (settings.lamp) return false;
    const glm::dvec3 s = settings.floor.sun.direction();
    if (-s.z <= steepest_slope(surface) * glm::length(glm::dvec2(s))) return false;
    const double lowest = std::min(0.0, least(surface.elevation));
    if (settings.bed_m && most(*settings.bed_m) >= lowest) return false;
    return objects.low_m().z > objects.high_m().z || objects.high_m().z < lowest;
}

std::unique_ptr<PhotonStarts> make_photon_starts(const PhotonSettings& settings, const WaterScene& scene) {
    using Start = PhotonOptions::Start;
    const Start start = settings.options.start;
    if (settings.lamp) return std::make_unique<LampImage>(settings, scene);
    const bool on_surface = start == Start::surface || (start == Start::automatic &&
                                                        starts_on_surface(settings, scene.surface(), scene.objects()));
    if (on_surface) return std::make_unique<SurfaceStarts>(settings, scene);
    return std::make_unique<SunImage>(settings, scene);
}

}  // namespace waterlight
