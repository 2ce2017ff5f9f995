#include "caustics/photons/screen_buffer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "caustics/photons/blur.hpp"
#include "caustics/photons/photon_pass.hpp"
#include "caustics/photons/photon_settings.hpp"

namespace waterlight {

namespace {

/// Deposits on the pixels of a camera.
class ScreenReceiver {
  public:
    ScreenReceiver(const WaterScene& scene, const Camera& camera)
        : scene_(scene), rays_(camera.rays()), eye_(camera.position_m), size_(camera.size) {
        pixel_ = glm::length(rays_.right) * glm::length(rays_.up);
    }

    void operator()(std::span<const PhotonLanding> landings, std::vector<PhotonDeposit>& deposits, FloorLedger&) const {
        for (const PhotonLanding& landing : landings) {
            const std::optional<std::int64_t> pixel = pixel_of(landing.at_m);
            const glm::dvec3 from = landing.at_m - eye_;
            const double facing = -glm::dot(landing.normal, from);
            if (!pixel || facing <= 0 || !sees(landing.at_m)) continue;
            // Seen at depth z along the view, a pixel covers pixel z^3 / |normal . from| of the receiver.
            const double z = glm::dot(from, rays_.forward);
            deposits.push_back({*pixel, landing.power_w * facing / (pixel_ * z * z * z)});
        }
    }

  private:
    std::optional<std::int64_t> pixel_of(glm::dvec3 at) const {
        const glm::dvec3 from = at - eye_;
        const double z = glm::dot(from, rays_.forward);
        if (z <= 0) return std::nullopt;
        const glm::dvec3 v = from / z - rays_.corner;
        const double i = std::floor(glm::dot(v, rays_.right) / glm::dot(rays_.right, rays_.right) + 0.5),
                     j = std::floor(glm::dot(v, rays_.up) / glm::dot(rays_.up, rays_.up) + 0.5);
        if (!(i >= 0 && i < size_.x && j >= 0 && j < size_.y)) return std::nullopt;
        return static_cast<std::int64_t>(j) * size_.x + static_cast<std::int64_t>(i);
    }

    /// Whether nothing opaque stands between the place and the eye.
    bool sees(glm::dvec3 at) const {
        const glm::dvec3 way = eye_ - at;
        const double length = glm::length(way);
        // From below water's upper side is not met, nor from above its lower side.
        Traveller back{{at, way / length, 1e-7, length}, way.z < 0};
        constexpr int most_panes = 64;
        for (int k = 0; k < most_panes; ++k) {
            const SceneHit hit = scene_.first_hit(back);
            if (hit.what == SceneHit::What::nothing || hit.what == SceneHit::What::side) return true;
            if (hit.what == SceneHit::What::floor) return false;
            if (hit.what == SceneHit::What::object &&
                scene_.objects().object(hit.object).material.type != Material::Type::glass)
                return false;
            back.ray.nearest_m = hit.distance_m + 1e-7;
        }
        return false;
    }

    const WaterScene& scene_;
    Camera::Rays rays_;
    glm::dvec3 eye_;
    glm::ivec2 size_;
    double pixel_ = 0;  ///< area of a pixel where the depth is 1
};

}  // namespace

Field<float> screen_photons(const PhotonSettings& settings, const WaterScene& scene, const Camera& camera) {
    validate(settings);
    Field<double> sum(camera.size.x, camera.size.y);
    Field<float> irradiance(camera.size.x, camera.size.y);
    if (!is_lit(settings)) return irradiance;
    const std::unique_ptr<PhotonTracer> tracer = make_scene_tracer(settings, scene);
    const ScreenReceiver receiver(scene, camera.mirrored ? mirrored(camera) : camera);
    FloorLedger ledger;
    for (int pass = 0; pass < settings.options.passes; ++pass)
        run_pass(*tracer, photons_of_pass(settings.options), pass, receiver, sum, ledger);
    const Field<double> smooth = blurred(sum, {.sigma_pixels = settings.options.blur_pixels});
    std::ranges::transform(smooth.values(), irradiance.values().begin(),
                           [&](double e) { return static_cast<float>(e / settings.options.passes); });
    return irradiance;
}

}  // namespace waterlight
