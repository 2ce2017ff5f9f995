#include "scenarios/resolve_picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scenarios/resolve_light.hpp"
#include "scenarios/scene_spectrum.hpp"

namespace waterlight {

namespace {

constexpr double error_share = 0.1;  // of the irradiance shown: more than that is no longer an error

/// The height of the waves, with room for two crests that meet.
double known_elevation_max(const Scenario& s) {
    const SceneSpectrum waves = scene_spectrum(s);
    const double height = std::max(2 * waves.amplitude_m(), waves.jump_m);
    if (height > 0) return height;
    s.origin.reject("picture.overlay", "elevation, of waves whose height is not known beforehand",
                    "output.elevation_max_m or picture.range_high beside it");
}

double highest(const Scenario& s) {
    if (s.picture.range_high) return *s.picture.range_high;
    if (s.picture.look.overlay == Overlay::elevation)
        return s.output.elevation_max_m ? *s.output.elevation_max_m : known_elevation_max(s);
    return irradiance_max(s) * (s.picture.look.overlay == Overlay::error ? error_share : 1);
}

}  // namespace

double irradiance_max(const Scenario& s) {
    const double still = still_irradiance(s);
    return s.output.irradiance_max_w_m2.value_or(still > 0 ? 3 * still : 1);
}

Look look_of(const Scenario& s) {
    Look look = s.picture.look;
    if (look.overlay == Overlay::none) return look;
    const double high = highest(s), low = look.overlay == Overlay::irradiance ? 0 : -high;
    look.range = {s.picture.range_low.value_or(low), high};
    if (look.range.low < look.range.high) return look;
    s.origin.reject("picture.range_low", fmt::format("{}", look.range.low),
                    fmt::format("< picture.range_high = {}", look.range.high));
}

}  // namespace waterlight
