#include "render/traced/traced_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "caustics/beam_volume.hpp"
#include "render/kernels/tone.hpp"
#include "render/scene_light.hpp"
#include "render/traced/tracer.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

void validate(const TraceOptions& o, const Look& look) {
    if (o.samples < 1) throw InputError(fmt::format("traced picture: {} samples of a pixel; at least 1", o.samples));
    if (o.bounces < 1) throw InputError(fmt::format("traced picture: {} bounces; at least 1", o.bounces));
    if (!(o.least_share >= 0 && o.least_share < 1))
        throw InputError(fmt::format("traced picture: the least share is {}; in [0, 1)", o.least_share));
    if (look.overlay != Overlay::none) throw InputError("traced picture: it has no overlays");
}

/// Irradiance of a lamp on the floor, of a spot where its axis goes, across the beam.
double on_floor(const Lamp& lamp, double depth_m) {
    const double height = lamp.at_m.z + depth_m;
    double way = height;
    if (lamp.type == Lamp::Type::spot) {
        const glm::dvec3 axis = glm::normalize(lamp.towards_m - lamp.at_m);
        if (axis.z < 0) way = height / -axis.z;
    }
    way = std::max(std::abs(way), 1e-3);
    return lamp.intensity_w_sr / (way * way);
}

/// What the look leaves open is told by the sun; where there is a lamp, by it as well.
Look with_lamp(const Look& look, const TracedScene& scene) {
    Look own = look;
    if (!scene.lamp) return own;
    const Sun& sun = scene.scene.sun;
    const double lamp = on_floor(*scene.lamp, scene.scene.depth_m);
    if (!own.sky.irradiance_w_m2) own.sky.irradiance_w_m2 = (sunlight(sun) + lamp) / 6;
    if (!own.exposure_w_m2_sr) {
        const double down = sunlight(sun) * std::max(0.0, -sun.direction().z);
        own.exposure_w_m2_sr = std::max((down + lamp + *own.sky.irradiance_w_m2) / std::numbers::pi, 1e-12);
    }
    return own;
}

WaterSceneSettings water_settings(const TracedScene& scene, Field<float>* ground) {
    WaterSceneSettings s;
    s.depth_m = scene.scene.depth_m;
    if (ground != nullptr) s.bed_m = std::shared_ptr<const Field<float>>(ground, [](const Field<float>*) {});
    s.optics = scene.scene.optics;
    s.wavelength_nm = scene.wavelength_nm;
    s.objects = scene.objects ? scene.objects : std::make_shared<const ObjectSet>(std::vector<Object>{});
    s.still_beyond_m = 3e4;
    return s;
}

/// Light in the water under waves, where diffuse things may be in it.
std::optional<BeamVolume> light_on_things(const TracedScene& scene) {
    const auto is_diffuse = [](const Object& o) { return o.material.type == Material::Type::diffuse; };
    const Surface& surface = *scene.scene.surface;
    if (!scene.objects || std::ranges::none_of(scene.objects->objects(), is_diffuse)) return std::nullopt;
    if (!(sunlight(scene.scene.sun) > 0) || scene.scene.optics.refractive_index == 1) return std::nullopt;
    if (std::ranges::all_of(surface.elevation.values(), [](float e) { return e == 0; })) return std::nullopt;
    constexpr int most = 256, slices = 48;
    const double lowest = scene.scene.ground_m != nullptr ? std::ranges::min(scene.scene.ground_m->values()) : 0;
    BeamSettings settings;
    settings.grid = glm::min(glm::ivec2(surface.grid.nx, surface.grid.ny), glm::ivec2(most));
    settings.depth_m = scene.scene.ground_m != nullptr ? std::max(-lowest, 1e-3) : scene.scene.depth_m;
    settings.sun = scene.scene.sun;
    settings.optics = scene.scene.optics;
    Beams beams;
    make_beams(settings, surface, beams);
    BeamVolume volume;
    fill_volume(beams, {settings.grid, slices}, volume);
    return volume;
}

}  // namespace

TracedPicture trace_picture(const TracedScene& scene, const Look& look, const Camera& camera,
                            const TraceOptions& options) {
    validate(options, look);
    const Look own = with_lamp(look, scene);
    validate(scene.scene, own, camera);
    Field<float> ground;
    if (scene.scene.ground_m != nullptr) ground = scene.scene.ground_m->clone();
    const WaterScene water(water_settings(scene, scene.scene.ground_m != nullptr ? &ground : nullptr),
                           *scene.scene.surface);
    SceneData data(scene.scene, own, camera);
    const std::optional<BeamVolume> light = light_on_things(scene);
    if (light) data.light_things_by(*light);
    TracedPicture picture;
    picture.radiance.size = camera.size;
    picture.radiance.rgb.resize(3 * static_cast<std::size_t>(camera.size.x) * static_cast<std::size_t>(camera.size.y));
    picture.exposure_w_m2_sr = 1 / static_cast<double>(data.text().s.per_exposure);
    const int across = std::max(1, static_cast<int>(std::floor(std::sqrt(options.samples) + 1e-9)));
    std::mutex telling;
    int done = 0;
#pragma omp parallel
    {
        Tracer tracer(scene, water, data, options);
#pragma omp for schedule(dynamic)
        for (int j = 0; j < camera.size.y; ++j) {
            float* to = picture.radiance.rgb.data() + 3 * static_cast<std::ptrdiff_t>(j) * camera.size.x;
            for (int i = 0; i < camera.size.x; ++i, to += 3) {
                glm::dvec3 sum{0, 0, 0};
                for (int k = 0; k < across * across; ++k) {
                    const glm::dvec2 part{(k % across + 0.5) / across - 0.5, (k / across + 0.5) / across - 0.5};
                    const unsigned seed = static_cast<unsigned>((j * camera.size.x + i) * across * across + k);
                    sum += tracer.seen_at(glm::dvec2(i, j) + part, 1.0 / across, seed);
                }
                sum /= across * across;
                for (int c = 0; c < 3; ++c) to[c] = static_cast<float>(sum[c]);
            }
            if (!options.progress) continue;
            const std::lock_guard lock(telling);
            options.progress(static_cast<double>(++done) / camera.size.y);
        }
    }
    return picture;
}

ColourImage developed(const TracedPicture& picture) {
    const glm::ivec2 size = picture.radiance.size;
    ColourImage image{size.x, size.y, std::vector<std::uint8_t>(picture.radiance.rgb.size())};
    std::uint8_t* to = image.pixels.data();
    for (int j = size.y - 1; j >= 0; --j) {
        const float* from = picture.radiance.rgb.data() + 3 * static_cast<std::ptrdiff_t>(j) * size.x;
        for (int k = 0; k < 3 * size.x; ++k, ++to) {
            const auto x = static_cast<float>(from[k] / picture.exposure_w_m2_sr);
            *to = static_cast<std::uint8_t>(std::lround(255 * f32::srgb_encoded(f32::filmic(x))));
        }
    }
    return image;
}

}  // namespace waterlight
