#include "app/lit_mapper.hpp"

#include "scenarios/resolve_light.hpp"

namespace waterlight {

namespace {

/// Keeps in `latest` what it makes.
FloorMaker noted(const FloorMaker& make, std::shared_ptr<const FloorMapper*> latest) {
    return [make, latest = std::move(latest)](const FloorSettings& s) {
        std::unique_ptr<FloorMapper> mapper = make(s);
        *latest = mapper.get();
        return mapper;
    };
}

}  // namespace

LitMapper make_lit_mapper(const Scenario& scenario, const FloorSettings& settings, FloorMaker make) {
    LitMapper lit;
    const FloorMaker one_wavelength = [&](const FloorSettings& s) {
        lit.own.push_back(std::make_shared<const FloorMapper*>(nullptr));
        const FloorMaker parallel = noted(make, lit.own.back());
        return scenario.sun.disc_deg ? make_sun_disc(s, *scenario.sun.disc_deg, parallel) : parallel(s);
    };
    const std::vector<Band> bands = bands_of(scenario);
    if (bands.empty()) {
        lit.mapper = one_wavelength(settings);
        return lit;
    }
    auto spectral = std::make_unique<SpectralFloor>(settings, bands, one_wavelength);
    lit.spectral = spectral.get();
    lit.mapper = std::move(spectral);
    return lit;
}

}  // namespace waterlight
