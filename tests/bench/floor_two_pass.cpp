// floor_two_pass/BACKEND/WIDTHxHEIGHT/N: one floor map of a moving pool with the paper's footprint, seconds per frame;
// floor_two_pass_adaptive/... the same with the adaptive one. The surface has the map's
// own aspect and 256 cells along x; slopes are such that the window holds the light.
#include "tests/bench/floor_two_pass.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tests/support/surfaces.hpp"

namespace waterlight::bench {

namespace {

Surface pool(int width, int height) {
    const Grid grid = make_grid(256, 256 * height / width, 8, 8.0 * height / width);
    return test::sample(grid, {Side::wall, Side::wall},
                        test::sines({{.0006, 1, 0}, {.0004, .7, 40}, {.0003, .5, 110}, {.0005, 1.3, 75}}));
}

}  // namespace

static void floor_two_pass(benchmark::State& state, FloorCase c, Footprint footprint, const MakeMapper& make) {
    const Surface surface = pool(c.width, c.height);
    FloorSettings settings;
    settings.plan = cover(surface.grid, c.width, c.height);
    settings.footprint = footprint;
    settings.window = FloorWindow{c.window, c.window};
    settings.depth_m = 1;
    settings.sun.elevation_deg = 60;
    const std::unique_ptr<FloorMapper> mapper = make(settings);
    FloorMap map;
    mapper->compute(surface, map);
    for (auto _ : state) mapper->compute(surface, map);
    const double light = map.ledger.incident_w - map.ledger.reflected_w;
    state.counters["lost_percent"] = 100 * map.ledger.lost_w / light;
    state.counters["pixels_per_s"] =
        benchmark::Counter(double(c.width) * c.height, benchmark::Counter::kIsIterationInvariantRate);
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
