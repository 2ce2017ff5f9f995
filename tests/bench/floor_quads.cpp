// floor_quads/cpu/WIDTHxHEIGHT: one floor map by landed quads of the pool that floor_two_pass is timed on, seconds per
// frame.
#include <fmt/format.h>

#include "caustics/quads.hpp"
#include "tests/bench/floor_two_pass.hpp"

namespace waterlight::bench {

static void floor_quads(benchmark::State& state, FloorCase c) {
    const FloorScene scene = floor_scene(c);
    const std::unique_ptr<FloorMapper> mapper = make_floor_quads(scene.settings);
    FloorMap map;
    mapper->compute(scene.surface, map);
    for (auto _ : state) mapper->compute(scene.surface, map);
    count(state, scene, map);
}

void register_floor_quads() {
    for (const FloorCase c : {FloorCase{400, 300, 7}, {800, 600, 7}, {1024, 1024, 15}})
        benchmark::RegisterBenchmark(fmt::format("floor_quads/cpu/{}x{}", c.width, c.height).c_str(),
                                     [=](benchmark::State& state) { floor_quads(state, c); })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
}

}  // namespace waterlight::bench
