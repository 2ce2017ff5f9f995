// Light of several wavelengths, and the water as each of them feels it.
#pragma once

#include <span>
#include <vector>

#include "caustics/light.hpp"

namespace waterlight {

/// One wavelength of the sun's light.
struct Band {
    double wavelength_nm = 550;  ///< in vacuum, in [380, 700]
    double share = 1;            ///< of the sun's irradiance E0
    WaterOptics optics;          ///< of the water at this wavelength
};

/// Shortest and longest wavelength whose absorption is known.
inline constexpr double shortest_nm = 380, longest_nm = 700;

/// Absorption coefficient of pure water, 1/m, linear between the values that Pope & Fry, "Absorption spectrum (380-700
/// nm) of pure water. II. Integrating cavity measurements", Applied Optics 36 (1997), measured each 2.5 nm to some 5 %
/// (a tenth in the blue). Asserts a wavelength in [380, 700] nm.
double pure_water_absorption(double wavelength_nm);

/// Temperature and salinity of the water, and what is dissolved and floats in it, the same for all wavelengths.
struct WaterState {
    double temperature_c = 20;     ///< in [0, 30]
    double salinity_permille = 0;  ///< in [0, 40]
};

/// Water at one wavelength: its index (kernels/water_colour.glsl); absorption and scattering of pure water added to
/// those of `more`, whose phase function and Fresnel switch hold.
WaterOptics optics_at(double wavelength_nm, const WaterState& state, const WaterOptics& more);

/// Shares of the sun's irradiance in proportion to a black body's power at the wavelengths, which add up to 1: the
/// sun's surface is one of 5778 K within some 10 % in the visible.
std::vector<double> black_body_shares(std::span<const double> wavelengths_nm, double kelvin = 5778);

}  // namespace waterlight
