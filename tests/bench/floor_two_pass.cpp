// floor_two_pass/BACKEND/WIDTHxHEIGHT/N: one floor map of a moving pool with the paper's footprint, seconds per frame;
// floor_two_pass_adaptive/... the same with the adaptive one. The surface has the map's
// own aspect and 256 cells along x; slopes are such that the window holds the light.
#include "tests/bench/floor_two_pass.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tests/support/surfaces.hpp"

namespace waterlight::bench {

namespace {

const test::Formula waves = test::sines({{.0006, 1, 0}, {.0004, .7, 40}, {.0003, .5, 110}, {.0005, 1.3, 75}});

/// Percent, over the middle of the map.
double rmse_percent(const FloorScene& scene, const FloorMap& map) {
    constexpr int middle = 96;
    const FloorPlan& plan = scene.settings.plan;
    const glm::ivec2 first{(plan.width - middle) / 2, (plan.height - middle) / 2};
    TruthSettings truth{scene.settings, 4, 16, 1e-3};
    truth.floor.plan.origin_m = plan.position_m(first);
    truth.floor.plan.width = truth.floor.plan.height = middle;
    const Surface& surface = scene.surface;
    const TruthMap exact = truth_map(truth, test::as_truth(surface.grid, surface.boundary, waves));
    Field<float> part(middle, middle);
    for (int j = 0; j < middle; ++j)
        for (int i = 0; i < middle; ++i) part(i, j) = map.irradiance(first.x + i, first.y + j);
    return 100 * relative_rmse(part, exact.irradiance);
}

}  // namespace

FloorScene floor_scene(const FloorCase& c) {
    const Grid grid = make_grid(256, 256 * c.height / c.width, 8, 8.0 * c.height / c.width);
    FloorScene scene{test::sample(grid, {Side::wall, Side::wall}, waves), {}};
    scene.settings.plan = cover(grid, c.width, c.height);
    scene.settings.window = FloorWindow{c.window, c.window};
    scene.settings.depth_m = 1;
    scene.settings.sun.elevation_deg = 60;
    return scene;
}

void count(benchmark::State& state, const FloorScene& scene, const FloorMap& map) {
    const double light = map.ledger.incident_w - map.ledger.reflected_w;
    state.counters["lost_percent"] = 100 * map.ledger.lost_w / light;
    state.counters["rmse_percent"] = rmse_percent(scene, map);
    state.counters["pixels_per_s"] =
        benchmark::Counter(static_cast<double>(map.irradiance.size()), benchmark::Counter::kIsIterationInvariantRate);
}

static void floor_two_pass(benchmark::State& state, FloorCase c, Footprint footprint, const MakeMapper& make) {
    FloorScene scene = floor_scene(c);
    scene.settings.footprint = footprint;
    const std::unique_ptr<FloorMapper> mapper = make(scene.settings);
    FloorMap map;
    mapper->compute(scene.surface, map);
    for (auto _ : state) mapper->compute(scene.surface, map);
    count(state, scene, map);
}

void register_floor(const std::string& backend, const MakeMapper& make) {
    for (const Footprint footprint : {Footprint::pixel, Footprint::adaptive}) {
        const char* kind = footprint == Footprint::pixel ? "floor_two_pass" : "floor_two_pass_adaptive";
        for (const FloorCase c : {FloorCase{400, 300, 7}, {800, 600, 7}, {1024, 1024, 15}}) {
            const std::string name = fmt::format("{}/{}/{}x{}/N{}", kind, backend, c.width, c.height, c.window);
            benchmark::RegisterBenchmark(name.c_str(),
                                         [=](benchmark::State& state) { floor_two_pass(state, c, footprint, make); })
                ->Unit(benchmark::kMillisecond)
                ->UseRealTime();
        }
    }
}

}  // namespace waterlight::bench
