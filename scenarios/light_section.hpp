// What a scenario says of light beyond a parallel beam of one colour.
#pragma once

#include <optional>
#include <vector>

#include "caustics/water_colour.hpp"

namespace waterlight {

/// Ready sets of wavelengths.
enum class Colour { none, rgb };

struct SunSection {
    std::optional<double> disc_deg;  ///< half-angle; none: parallel light
    Colour colour = Colour::none;
    std::vector<double> wavelengths_nm;  ///< empty: those of the colour, or light of one colour
    std::vector<double> shares;          ///< of E0; empty: a black body's
};

/// What the floor map lies on, and what its irradiance is per.
enum class Receiver { flat, ground };
enum class PerArea { ground, horizontal };

struct ReceiverSection {
    Receiver receiver = Receiver::flat;
    PerArea per_area = PerArea::ground;  ///< of receiver ground
};

/// Pool walls as receivers of light.
struct WallsSection {
    double pixel_m = 0.01;
    double above_m = 0.1;
};

struct WaterColourSection {
    WaterState state;
    std::vector<double> absorption_by_band_per_m;  ///< in place of pure water's; empty: pure water
    std::vector<double> scattering_by_band_per_m;
};

}  // namespace waterlight
