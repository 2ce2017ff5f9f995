// waves_airy/cpu/N: one frame of a periodic sea of N x N cells: the state turned to its new time, elevation and both
// slopes. waves_airy_walls/cpu/512x384 is the pool's.
#include <benchmark/benchmark.h>

#include "sim/airy.hpp"

namespace waterlight {
namespace {

void airy_frames(benchmark::State& state, const Grid& grid, Side side) {
    AirySettings settings;
    settings.grid = grid;
    settings.boundary = {side, side};
    settings.water.depth_m = 2;
    settings.sources = {Drop{{grid.width_m() / 3, grid.height_m() / 2}, 0.2, 0.02, 0}};
    const std::unique_ptr<AiryModel> model = make_airy(settings);
    for (auto _ : state) {
        model->advance(1.0 / 60);
        benchmark::DoNotOptimize(model->surface().elevation.data());
    }
    state.counters["cells"] =
        benchmark::Counter(static_cast<double>(grid.cells()), benchmark::Counter::kIsIterationInvariantRate);
}

void waves_airy(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    airy_frames(state, make_grid(n, n, 16, 16), Side::periodic);
}

void pool(benchmark::State& state) { airy_frames(state, make_grid(512, 384, 8, 6), Side::wall); }

BENCHMARK(waves_airy)->Name("waves_airy/cpu")->Arg(256)->Arg(1024)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(pool)->Name("waves_airy_walls/cpu/512x384")->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace waterlight
