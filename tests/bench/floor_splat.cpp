// floor_splat/BACKEND/WIDTHxHEIGHT/V: one floor map by caustics mapping of the pool that floor_two_pass is timed on, V
// vertices along x; floor_splat/BACKEND/fixed/... the same with the paper's fixed splats;
// floor_splat/BACKEND/glass_ball/... with a glass ball of 1 m in the middle of it. Seconds per frame.
#include <fmt/format.h>

#include "caustics/splat/splat.hpp"
#include "tests/bench/floor_two_pass.hpp"

namespace waterlight::bench {

namespace {

struct SplatCase {
    FloorCase floor;
    int vertices;
    SplatOptions::Size size = SplatOptions::Size::jacobian;
    bool glass = false;
};

}  // namespace

static void floor_splat(benchmark::State& state, const SplatCase& c, const MakeSplats& make) {
    const FloorScene scene = floor_scene(c.floor);
    SplatSettings settings{.floor = scene.settings};
    settings.options.grid = c.vertices;
    settings.options.size = c.size;
    if (c.glass)
        settings.floor.objects = std::make_shared<ObjectSet>(std::vector<Object>{
            {.shape = Sphere{0.5}, .material = {.type = Material::Type::glass}, .centre_m = {4, 3, -0.5}}});
    const std::unique_ptr<SplatFloor> mapper = make(settings);
    FloorMap map;
    mapper->compute(scene.surface, map);
    for (auto _ : state) mapper->compute(scene.surface, map);
    state.counters["vertices"] = static_cast<double>(mapper->report().vertices);
    if (!c.glass) count(state, scene, map);
}

void register_floor_splat(const std::string& backend, const MakeSplats& make) {
    const auto add = [&](const std::string& kind, const SplatCase& c) {
        const std::string name =
            fmt::format("floor_splat/{}/{}{}x{}/{}", backend, kind, c.floor.width, c.floor.height, c.vertices);
        benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { floor_splat(state, c, make); })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
    };
    for (const FloorCase c : {FloorCase{400, 300, 7}, {800, 600, 7}, {1024, 1024, 15}}) add("", {c, c.width});
    for (const int vertices : {200, 800}) add("", {{400, 300, 7}, vertices});
    add("fixed/", {{400, 300, 7}, 400, SplatOptions::Size::fixed});
    add("glass_ball/", {{400, 300, 7}, 400, SplatOptions::Size::jacobian, true});
}

}  // namespace waterlight::bench
