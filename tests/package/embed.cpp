// An engine that drops a stone and looks at the floor.
#include <cmath>

#include "caustics/floor.hpp"
#include "caustics/kernels/optics.hpp"
#include "sim/airy.hpp"

int main() {
    using namespace waterlight;
    AirySettings settings;
    settings.grid = make_grid(64, 64, 2, 2);
    settings.sources = {Drop{.at_m = {1, 1}, .radius_m = 0.1, .height_m = 0.01}};
    const auto waves = make_airy(settings);
    waves->advance(0.5);
    FloorSettings floor;
    floor.plan = cover(settings.grid, 64, 64);
    FloorMap map;
    make_floor_cpu(floor)->compute(waves->surface(), map);
    const double transmitted = 1000 * f64::fresnel_transmittance(1, 1, 4.0 / 3);
    const double mean = map.ledger.floor_w / 4;
    return std::abs(mean / transmitted - 1) < 0.01 ? 0 : 1;
}
