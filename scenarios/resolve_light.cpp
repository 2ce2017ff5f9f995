#include "scenarios/resolve_light.hpp"

#include <cassert>

#include "caustics/kernels/optics.hpp"

namespace waterlight {

namespace {

const std::vector<double> rgb_nm{650, 550, 450};

const std::vector<double>& wavelengths_of(const SunSection& sun) {
    return sun.colour == Colour::rgb ? rgb_nm : sun.wavelengths_nm;
}

}  // namespace

std::vector<Band> bands_of(const Scenario& scenario) {
    const std::vector<double>& wavelengths = wavelengths_of(scenario.sun);
    const WaterColourSection& water = scenario.water_colour;
    std::vector<double> shares = scenario.sun.shares;
    if (shares.empty()) shares = black_body_shares(wavelengths);
    std::vector<Band> bands;
    for (std::size_t i = 0; i < wavelengths.size(); ++i) {
        WaterOptics optics = optics_at(wavelengths[i], water.state, scenario.optics);
        if (!water.absorption_by_band_per_m.empty()) optics.absorption_per_m = water.absorption_by_band_per_m[i];
        if (!water.scattering_by_band_per_m.empty()) optics.scattering_per_m = water.scattering_by_band_per_m[i];
        bands.push_back({wavelengths[i], shares[i], optics});
    }
    return bands;
}

WallSettings wall_settings(const Scenario& scenario) {
    assert(scenario.walls);
    return {.pixel_m = scenario.walls->pixel_m,
            .above_m = scenario.walls->above_m,
            .depth_m = scenario.domain.depth_m,
            .sun = scenario.light,
            .optics = scenario.optics};
}

double still_irradiance(const Scenario& s) {
    if (s.lamp) {
        const double height = s.lamp->at_m.z + s.domain.depth_m;
        return s.lamp->intensity_w_sr / (height * height);
    }
    std::vector<Band> bands = bands_of(s);
    if (bands.empty()) bands.push_back({.optics = s.optics});
    double sum = 0;
    for (const Band& band : bands) {
        const double n = band.optics.refractive_index, fresnel = band.optics.fresnel ? 1 : 0;
        const f64::Refraction r = f64::refract_sun(s.light.direction(), {0, 0}, n, fresnel);
        const double remaining = f64::beer_lambert(band.optics.extinction_per_m(), s.domain.depth_m * r.path);
        sum += band.share * s.light.irradiance_w_m2 * r.incident * r.transmittance * remaining;
    }
    return sum;
}

}  // namespace waterlight
