#include "app/lit_mapper.hpp"

#include "scenarios/resolve_light.hpp"

namespace waterlight {

LitMapper make_lit_mapper(const Scenario& scenario, const FloorSettings& settings, FloorMaker make) {
    if (scenario.sun.disc_deg)
        make = [parallel = std::move(make), half_angle = *scenario.sun.disc_deg](const FloorSettings& s) {
            return make_sun_disc(s, half_angle, parallel);
        };
    const std::vector<Band> bands = bands_of(scenario);
    if (bands.empty()) return {make(settings), nullptr};
    auto spectral = std::make_unique<SpectralFloor>(settings, bands, make);
    const SpectralFloor* view = spectral.get();
    return {std::move(spectral), view};
}

}  // namespace waterlight
