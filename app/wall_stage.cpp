#include "app/wall_stage.hpp"

#include <algorithm>

#include "scenarios/resolve_light.hpp"

namespace waterlight {

namespace {

void add(const WallMaps& from, WallMaps& to) {
    for (std::size_t w = 0; w < 4; ++w) {
        to.power_w[w] += from.power_w[w];
        for (std::size_t k = 0; k < to.irradiance[w].size(); ++k)
            to.irradiance[w].data()[k] += from.irradiance[w].data()[k];
    }
    to.ledger += from.ledger;
}

}  // namespace

void WallStage::compute(const Surface& surface) {
    const WallSettings settings = wall_settings(scenario_);
    const std::vector<Band> bands = bands_of(scenario_);
    if (bands.empty()) return light_walls(settings, surface, maps_);
    for (std::size_t k = 0; k < bands.size(); ++k) {
        WallSettings of_band = settings;
        of_band.sun.irradiance_w_m2 *= bands[k].share;
        of_band.optics = bands[k].optics;
        light_walls(of_band, surface, k == 0 ? maps_ : band_);
        if (k > 0) add(band_, maps_);
    }
}

void WallStage::add_frame() {
    record_.last_ledger = maps_.ledger;
    record_.sum += maps_.ledger;
    record_.closure = std::max(record_.closure, maps_.ledger.closure());
    record_.last_power_w = maps_.power_w;
}

}  // namespace waterlight
