#include "test_kit/world.hpp"

#include <fmt/format.h>

#include <cmath>

#include "caustics/truth.hpp"
#include "scenarios/build_floor.hpp"
#include "scenarios/memory.hpp"
#include "scenarios/reader.hpp"
#include "scenarios/resolve.hpp"
#include "sim/error.hpp"
#include "sim/field_norms.hpp"

namespace waterlight {

World::World(Scenario scenario) : scenario_(std::move(scenario)), waves_(build_model(scenario_)) {
    if (scenario_.floor && scenario_.floor->method != FloorMethod::truth)
        mapper_ = floor_maker(scenario_, receiver_bed(scenario_, waves_))(floor_settings(scenario_));
}

World World::from(const std::filesystem::path& scenario, const std::vector<std::string>& overrides) {
    return World(read_scenario(scenario, overrides));
}

World World::from_text(std::string_view toml, const std::vector<std::string>& overrides) {
    Scenario scenario = parse_scenario(toml, "world.toml", overrides);
    check_combinations(scenario);
    check_memory(scenario, machine_memory());
    find_data(scenario);
    read_data(scenario);
    return World(std::move(scenario));
}

void World::advance(double seconds) {
    if (!(seconds >= 0) || std::isinf(seconds))
        throw InputError(fmt::format("World::advance: found {} s; allowed: 0 or more", seconds));
    waves_.model->advance(seconds);
    time_s_ += seconds;
    is_mapped_ = false;
    const double mean = norms_of(std::span<const float>(surface().elevation.values())).mean;
    if (!std::isfinite(mean)) throw WorldError(fmt::format("the surface is not finite at t = {} s", time_s_));
}

const FloorMap& World::floor_map() {
    if (!mapper_)
        scenario_.origin.reject("caustics.floor", scenario_.floor ? "method = \"truth\"" : "no map to draw",
                                "caustics.floor with another method");
    if (!is_mapped_) mapper_->compute(surface(), map_);
    is_mapped_ = true;
    return map_;
}

double World::volume_m3() { return still_volume_m3(scenario_) + diagnostics().volume_m3; }

double World::elevation_at(glm::dvec2 at_m) { return interpolate(surface()).at(at_m).elevation_m; }

Grid World::grid() const { return grid_of(scenario_); }

}  // namespace waterlight
