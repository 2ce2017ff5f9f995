#include "caustics/photons/photon_settings.hpp"

#include <fmt/format.h>

#include <cmath>

#include "caustics/floor_frame.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

void require(bool good, std::string_view what, double found, std::string_view allowed) {
    if (!good) throw InputError(fmt::format("photons: {} is {}; allowed: {}", what, found, allowed));
}

void validate(const Lamp& lamp) {
    require(lamp.intensity_w_sr >= 0 && lamp.intensity_w_sr <= 1e30, "lamp's intensity in W/sr", lamp.intensity_w_sr,
            ">= 0, at most 1e30");
    for (int axis = 0; axis < 3; ++axis)
        require(std::abs(lamp.at_m[axis]) <= 1e30, "lamp's place in m", lamp.at_m[axis],
                "at most 1e30 from the origin");
    if (lamp.type != Lamp::Type::spot) return;
    require(lamp.half_angle_deg > 0 && lamp.half_angle_deg < 90, "lamp's half-angle in degrees", lamp.half_angle_deg,
            "between 0 and 90");
    const double length = glm::distance(lamp.at_m, lamp.towards_m);
    require(length > 0, "distance in m from the lamp to what it points at", length, "> 0");
}

}  // namespace

void validate(const PhotonSettings& settings) {
    const PhotonOptions& o = settings.options;
    validate(settings.floor);
    require(o.map >= 1 && o.map <= 65536, "photons along an axis", o.map, "1 to 65536");
    require(o.passes >= 1, "number of passes", o.passes, ">= 1");
    require(o.bounces >= 1, "number of bounces", o.bounces, ">= 1");
    require(o.tolerance >= 0, "tolerance", o.tolerance, ">= 0");
    require(o.tolerance == 0 || o.passes >= 2, "number of passes", o.passes, ">= 2 where there is a tolerance");
    require(o.blur_pixels >= 0 && o.blur_pixels <= 4096, "blur in pixels", o.blur_pixels, "0 to 4096");
    require(settings.floor.wavelength_nm > 0, "wavelength in nm", settings.floor.wavelength_nm, "> 0");
    if (!settings.lamp) return;
    validate(*settings.lamp);
    if (o.start == PhotonOptions::Start::surface)
        throw InputError("photons: their start is surface and the light is a lamp; allowed: light, automatic");
}

bool is_lit(const PhotonSettings& settings) {
    return settings.lamp ? settings.lamp->intensity_w_sr > 0 : settings.floor.sun.elevation_deg > 0;
}

}  // namespace waterlight
