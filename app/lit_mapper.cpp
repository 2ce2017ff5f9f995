#include "app/lit_mapper.hpp"

#include "caustics/relief.hpp"
#include "scenarios/resolve_light.hpp"

namespace waterlight {

FloorMaker ground_maker(const Scenario& scenario, const ShallowWaterModel& model) {
    return [&](const FloorSettings& floor) {
        const glm::ivec2 cells = scenario.domain.cells;
        ReliefSettings settings{floor, Field<float>(cells.x, cells.y), scenario.floor->on.per_area == PerArea::ground};
        for (int j = 0; j < cells.y; ++j)
            for (int i = 0; i < cells.x; ++i) settings.bed_m(i, j) = static_cast<float>(model.bed_m(i, j));
        return make_relief_floor(std::move(settings));
    };
}

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
