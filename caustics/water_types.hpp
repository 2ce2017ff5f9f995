// Optical properties of natural waters.
#pragma once

#include <array>
#include <string_view>

#include "caustics/light.hpp"

namespace waterlight {

/// Absorption, scattering and phase function of one kind of water at 514 nm.
struct WaterType {
    std::string_view name;
    double absorption_per_m;
    double scattering_per_m;
    double backscattered;  ///< part of the scattered light, measured
    Phase phase;
};

/// Petzold, "Volume scattering functions for selected ocean waters" (1972): clear water of the Tongue of the Ocean
/// (Bahamas), coastal water of the Santa Barbara Channel, turbid water of San Diego harbour; and pure sea water of
/// Smith & Baker, "Optical properties of the clearest natural waters" (1981); all as tabulated by Mobley, "Light and
/// Water" (1994), table 3.10. Phase functions are those of Fournier & Forand with the measured backscattered part, on
/// the line index = 1.01 + 0.1542 (slope - 3) along which Mobley, Sundman & Boss (2002) take oceanic particles.
inline constexpr std::array water_types{
    WaterType{"pure", 0.0405, 0.0025, 0.5, {.type = Phase::Type::pure_water}},
    WaterType{
        "clear-ocean", 0.114, 0.037, 0.044, {.type = Phase::Type::fournier_forand, .index = 1.1327, .slope = 3.7956}},
    WaterType{"coastal", 0.179, 0.219, 0.013, {.type = Phase::Type::fournier_forand, .index = 1.0897, .slope = 3.5166}},
    WaterType{"harbour", 0.366, 1.824, 0.020, {.type = Phase::Type::fournier_forand, .index = 1.1028, .slope = 3.6021}},
};

}  // namespace waterlight
