// The map that caustics mapping gives.
#pragma once

#include "caustics/splat/receivers.hpp"

namespace waterlight {

/// The receivers of a surface's light.
inline Receivers receivers_of(const SplatSettings& settings, const SplatFrame& frame, const Surface& surface) {
    return settings.bed_m ? Receivers(frame, surface, *settings.bed_m) : Receivers(frame.light.image);
}

/// Whether light meets nothing but water on its way.
inline bool water_alone(const SplatSettings& settings) {
    return !settings.floor.objects || settings.floor.objects->empty();
}

/// Irradiance and floor_w of the light in each pixel, row by row.
template <class Power>
void write_map(const SplatSettings& settings, const SplatFrame& frame, const Receivers& receivers, const Power* power_w,
               FloorMap& map) {
    const int width = frame.plan.width, height = frame.plan.height;
    if (map.irradiance.nx() != width || map.irradiance.ny() != height) map.irradiance = Field<float>(width, height);
    map.window = {1, 1};
    const bool sloping = !receivers.level() && settings.per_ground_area;
#pragma omp parallel for schedule(static)
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const double steepness = sloping ? receivers.steepness(frame.plan.position_m({i + 0.5, j + 0.5})) : 1;
            const double power = power_w[static_cast<std::ptrdiff_t>(j) * width + i];
            map.irradiance(i, j) = static_cast<float>(power / (frame.pixel_area_m2 * steepness));
        }
    double sum = 0;
    for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(width) * height; ++k) sum += power_w[k];
    map.ledger.floor_w = sum;
}

}  // namespace waterlight
