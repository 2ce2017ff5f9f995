#include "caustics/photons/open_water.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "caustics/kernels/optics.hpp"
#include "caustics/photons/photon_starts.hpp"
#include "caustics/surface_point.hpp"

namespace waterlight {

namespace {

double largest(const Field<float>& field) {
    double largest = 0;
    for (const float value : field.values()) largest = std::max<double>(largest, std::abs(value));
    return largest;
}

class OpenWaterTracer final : public PhotonTracer {
  public:
    OpenWaterTracer(const PhotonSettings& settings, const Surface& surface)
        : surface_(surface),
          domain_(surface),
          water_(lit_water(settings, surface)),
          sun_(settings.floor.sun.direction()),
          options_(settings.options),
          index_(settings.floor.optics.refractive_index),
          fresnel_(settings.floor.optics.fresnel ? 1 : 0),
          extinction_(settings.floor.optics.extinction_per_m()),
          depth_m_(settings.floor.depth_m) {
        const double photons = static_cast<double>(options_.map) * options_.map;
        photon_w_ = settings.floor.sun.irradiance_w_m2 * water_.size_m().x * water_.size_m().y / photons;
    }

    void trace(int pass, std::int64_t first, std::int64_t count, PhotonTally& tally) const override {
        const std::uint64_t key = PhotonRandom::key(options_.seed, pass);
        for (std::int64_t k = first; k < first + count; ++k) {
            PhotonRandom random(key, k);
            send(water_.low_m + random.within_cell(k, options_.map) * water_.size_m(), tally);
        }
    }

  private:
    void send(glm::dvec2 at, PhotonTally& tally) const {
        const SurfacePoint p = surface_point(surface_, at);
        const f64::Refraction r = f64::refract_sun(sun_, p.slope, index_, fresnel_);
        const bool own = domain_.holds(at);
        const double descent = std::max(0.0, p.elevation_m + depth_m_);
        const glm::dvec2 way = descent * r.travel;
        const double free = until_wall(at, way), entered = photon_w_ * r.incident * r.transmittance;
        const double left = entered * f64::beer_lambert(extinction_, free * descent * r.path);
        if (own) {
            tally.ledger.incident_w += photon_w_ * r.incident;
            tally.ledger.reflected_w += photon_w_ * r.incident - entered;
            tally.ledger.extinguished_w += entered - left;
            if (free < 1) tally.ledger.outside_w += left;
        }
        if (free < 1) return;
        const glm::dvec3 floor{at + way, -depth_m_};
        tally.landings.push_back({domain_.brought_in(floor, true), {0, 0, 1}, left, -1, own});
    }

    /// The part of the way that lies before a wall; 1: all of it.
    double until_wall(glm::dvec2 at, glm::dvec2 way) const {
        double part = 1;
        for (int axis = 0; axis < 2; ++axis) {
            if (domain_.side(axis) != Side::wall || way[axis] == 0) continue;
            const double side = domain_.low_m[axis] + (way[axis] > 0 ? domain_.size_m[axis] : 0);
            part = std::min(part, std::max(0.0, (side - at[axis]) / way[axis]));
        }
        return part;
    }

    const Surface& surface_;
    PhotonDomain domain_;
    LevelBox water_;
    glm::dvec3 sun_;
    PhotonOptions options_;
    double index_, fresnel_, extinction_, depth_m_;
    double photon_w_ = 0;  ///< per incident factor
};

}  // namespace

bool is_open_water(const PhotonSettings& settings, const Surface& surface) {
    const FloorSettings& floor = settings.floor;
    if (settings.lamp || settings.options.start == PhotonOptions::Start::light || settings.bed_m ||
        (floor.objects && !floor.objects->empty()))
        return false;
    // Angles from the vertical: of the sun, at most of a normal, of what is refracted and of what is reflected there.
    const double sun = std::numbers::pi / 2 - floor.sun.elevation_deg * std::numbers::pi / 180;
    const double normal = std::atan(std::hypot(largest(surface.slope_x), largest(surface.slope_y)));
    const double in = std::min(sun + normal, std::numbers::pi / 2);
    const double refracted = std::asin(std::sin(in) / floor.optics.refractive_index) + normal;
    const double steepest = std::numbers::pi / 2 - std::atan(steepest_slope(surface));
    return std::max({sun, refracted, sun + 2 * normal}) < steepest - 1e-9;
}

std::unique_ptr<PhotonTracer> make_open_water_tracer(const PhotonSettings& settings, const Surface& surface) {
    return std::make_unique<OpenWaterTracer>(settings, surface);
}

}  // namespace waterlight
