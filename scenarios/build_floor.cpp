#include "scenarios/build_floor.hpp"

#include <cassert>

#include "caustics/quads.hpp"
#include "caustics/relief.hpp"

namespace waterlight {

namespace {

std::optional<Lamp> lamp_of(const Scenario& scenario, const FloorSettings& floor) {
    std::optional<Lamp> lamp = scenario.lamp;
    const double all = scenario.light.irradiance_w_m2;
    if (lamp && all > 0) lamp->intensity_w_sr *= floor.sun.irradiance_w_m2 / all;
    return lamp;
}

bool is_per_ground_area(const Scenario& scenario) { return scenario.floor->on.per_area == PerArea::ground; }

std::unique_ptr<FloorMapper> make_two_pass(const Scenario& scenario, const FloorSettings& floor,
                                           const Field<float>* bed_m) {
    if (!bed_m) return make_floor_cpu(floor);
    return make_relief_floor({floor, bed_m->clone(), is_per_ground_area(scenario)});
}

}  // namespace

std::shared_ptr<const Field<float>> receiver_bed(const Scenario& scenario, const BuiltModel& model) {
    if (!scenario.floor || scenario.floor->on.receiver != Receiver::ground) return nullptr;
    assert(model.shallow);
    const glm::ivec2 cells = scenario.domain.cells;
    auto bed = std::make_shared<Field<float>>(cells.x, cells.y);
    for (int j = 0; j < cells.y; ++j)
        for (int i = 0; i < cells.x; ++i) (*bed)(i, j) = static_cast<float>(model.shallow->bed_m(i, j));
    return bed;
}

SplatSettings splat_settings(const Scenario& scenario, const FloorSettings& floor,
                             std::shared_ptr<const Field<float>> bed_m) {
    return {floor, scenario.floor->splat, lamp_of(scenario, floor), std::move(bed_m), is_per_ground_area(scenario)};
}

PhotonSettings photon_settings(const Scenario& scenario, const FloorSettings& floor,
                               std::shared_ptr<const Field<float>> bed_m) {
    return {floor, scenario.floor->photons, lamp_of(scenario, floor), std::move(bed_m), is_per_ground_area(scenario)};
}

FloorMaker floor_maker(const Scenario& scenario, std::shared_ptr<const Field<float>> bed_m) {
    return [&scenario, bed = std::move(bed_m)](const FloorSettings& floor) -> std::unique_ptr<FloorMapper> {
        switch (scenario.floor->method) {
            case FloorMethod::quads:
                return make_floor_quads(floor);
            case FloorMethod::splat:
                return make_splat_floor_cpu(splat_settings(scenario, floor, bed));
            case FloorMethod::photons:
                return make_photon_floor(photon_settings(scenario, floor, bed));
            default:
                return make_two_pass(scenario, floor, bed.get());
        }
    };
}

}  // namespace waterlight
