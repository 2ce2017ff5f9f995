#include "scenarios/schema_light.hpp"

#include "scenarios/schema_parts.hpp"

namespace waterlight {

using namespace schema;

void describe_sun(Visitor& v, SunSection& s) {
    v.value({"disc_deg",
             "deg",
             "Half-angle of the sun's disc, which blurs the floor map; as seen from the earth 0.2665.",
             {.low = 0, .high = 10, .excludes_low = true},
             false,
             "parallel light"},
            &s.disc_deg);
    v.value({"colour", "",
             "rgb: wavelengths_nm = [650, 550, 450]. Each wavelength has its own floor map through water of its own "
             "index, absorption and scattering."},
            choice(s.colour, {"none", "rgb"}));
    v.value({"wavelengths_nm",
             "nm",
             "Wavelengths of the light, each with a floor map; \"irradiance\" is their sum.",
             {.low = shortest_nm, .high = longest_nm},
             false,
             "light of one colour"},
            &s.wavelengths_nm);
    v.value({"shares",
             "",
             "Share of irradiance_w_m2 in each wavelength, up to 1 together.",
             {.low = 0, .high = 1, .excludes_low = true},
             false,
             "in proportion to a black body of 5778 K, 1 together"},
            &s.shares);
}

void describe_receiver(Visitor& v, ReceiverSection& s) {
    v.value(
        {"receiver", "",
         "What the map lies on: the flat floor at domain.depth_m, or the ground of model shallow-water, which light "
         "is followed to."},
        choice(s.receiver, {"flat", "ground"}));
    v.value({"per_area", "", "What irradiance on the ground is per: the sloping ground's area, or horizontal area."},
            choice(s.per_area, {"ground", "horizontal"}));
}

void describe_walls(Visitor& v, WallsSection& s) {
    v.value({"pixel_m",
             "m",
             "Size of a pixel at most; whole pixels fill a wall's length and depth.",
             {.low = 0, .excludes_low = true}},
            &s.pixel_m);
    v.value({"above_m", "m", "How far the maps reach above still water, for crests; light above it is outside.",
             not_negative},
            &s.above_m);
}

void describe_water_colour(Visitor& v, WaterColourSection& s) {
    v.value({"temperature_c",
             "deg C",
             "Temperature, on which the index of light in colour depends.",
             {.low = 0, .high = 30}},
            &s.state.temperature_c);
    v.value({"salinity_permille",
             "permille",
             "Salinity, on which index and scattering of light in colour depend; the sea's is 35.",
             {.low = 0, .high = 40}},
            &s.state.salinity_permille);
    v.value({"absorption_by_band_per_m", "1/m", "Absorption coefficient of each wavelength of the light.", not_negative,
             false, "pure water's, and absorption_per_m"},
            &s.absorption_by_band_per_m);
    v.value({"scattering_by_band_per_m", "1/m", "Scattering coefficient of each wavelength of the light.", not_negative,
             false, "pure water's, and scattering_per_m"},
            &s.scattering_by_band_per_m);
}

}  // namespace waterlight
