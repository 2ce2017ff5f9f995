// Optical properties of natural waters.
#pragma once

#include <array>
#include <string_view>

#include "caustics/light.hpp"

namespace waterlight {

/// Absorption, scattering and phase function of one kind of water at 514 nm, where Petzold's instrument was most
/// sensitive (half of that 75 nm apart).
struct WaterType {
    std::string_view name;
    double absorption_per_m;
    double scattering_per_m;
    double backscattered;  ///< part of the scattered light, measured
    Phase phase;
};

/// Petzold, "Volume scattering functions for selected ocean waters" (1972, SIO Ref. 72-78): clear water of the Tongue
/// of the Ocean (Bahamas, his AUTEC), coastal water of the San Pedro Channel (California, HAOCE), turbid water of San
/// Diego harbour (NUC); and pure sea water between 510 and 520 nm of Smith & Baker, "Optical properties of the clearest
/// natural waters" (1981), Appl. Opt. 20, 177: a 0.0357 and 0.0477, b 0.0026 and 0.0024 1/m. All as tabulated by
/// Mobley, "Light and Water" (1994), tables 3.5 and 3.10. Phase functions are those of Fournier & Forand with the
/// measured backscattered part, on the line index = 1.01 + 0.1542 (slope - 3) along which Mobley, Sundman & Boss
/// (2002), Appl. Opt. 41, 1035, take oceanic particles.
inline constexpr std::array water_types{
    WaterType{"pure", 0.0405, 0.0025, 0.5, {.type = Phase::Type::pure_water}},
    WaterType{
        "clear-ocean", 0.114, 0.037, 0.044, {.type = Phase::Type::fournier_forand, .index = 1.1327, .slope = 3.7956}},
    WaterType{"coastal", 0.179, 0.219, 0.013, {.type = Phase::Type::fournier_forand, .index = 1.0897, .slope = 3.5166}},
    WaterType{"harbour", 0.366, 1.824, 0.020, {.type = Phase::Type::fournier_forand, .index = 1.1028, .slope = 3.6021}},
};

}  // namespace waterlight
