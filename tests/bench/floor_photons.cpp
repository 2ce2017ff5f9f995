// floor_photons/START/WIDTHxHEIGHT/MAPxMAP: one floor map by one pass of photons of the pool that floor_two_pass is
// timed on; floor_photons/glass_ball/...: with a glass ball of 1 m in the middle of it, split or by roulette. Seconds
// per map.
#include <fmt/format.h>

#include "caustics/photons/photons.hpp"
#include "tests/bench/floor_two_pass.hpp"

namespace waterlight::bench {

namespace {

using Start = PhotonOptions::Start;
using Branching = PhotonOptions::Branching;

void photons(benchmark::State& state, const FloorScene& scene, const PhotonSettings& settings, bool has_truth) {
    const std::unique_ptr<PhotonFloor> floor = make_photon_floor(settings);
    FloorMap map;
    for (auto _ : state) floor->compute(scene.surface, map);
    if (has_truth) count(state, scene, map);
    state.counters["photons_per_s"] =
        benchmark::Counter(static_cast<double>(floor->photons()), benchmark::Counter::kIsIterationInvariantRate);
}

void open_pool(benchmark::State& state, FloorCase c, Start start, int map) {
    const FloorScene scene = floor_scene(c);
    photons(state, scene, {.floor = scene.settings, .options = {.start = start, .map = map}}, true);
}

void glass_ball(benchmark::State& state, Branching branching) {
    FloorScene scene = floor_scene({400, 300, 7});
    scene.settings.objects = std::make_shared<ObjectSet>(std::vector<Object>{
        {.name = "ball", .shape = Sphere{0.5}, .material = {Material::Type::glass}, .centre_m = {4, 3, -0.2}}});
    photons(state, scene, {.floor = scene.settings, .options = {.branching = branching, .map = 512}}, false);
}

}  // namespace

void register_floor_photons() {
    const auto add = [](const std::string& name, auto run) {
        benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond)->UseRealTime();
    };
    for (const int map : {512, 1024, 2048, 4096})
        add(fmt::format("floor_photons/surface/400x300/{0}x{0}", map), [map](benchmark::State& state) {
            open_pool(state, {400, 300, 7}, Start::surface, map);
        });
    add("floor_photons/surface/800x600/2048x2048", [](benchmark::State& state) {
        open_pool(state, {800, 600, 7}, Start::surface, 2048);
    });
    add("floor_photons/light/400x300/1024x1024", [](benchmark::State& state) {
        open_pool(state, {400, 300, 7}, Start::light, 1024);
    });
    add("floor_photons/glass_ball/400x300/512x512/roulette",
        [](benchmark::State& state) { glass_ball(state, Branching::roulette); });
    add("floor_photons/glass_ball/400x300/512x512/split",
        [](benchmark::State& state) { glass_ball(state, Branching::split); });
}

}  // namespace waterlight::bench
