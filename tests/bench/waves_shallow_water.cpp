// waves_shallow_water/BACKEND/CELLS/SCENE: cells times steps per second, one step being both stages. wet: a hump of
// water over a flat bed; shore: an island with its moving shore, and friction.
#include "tests/bench/waves_shallow_water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace waterlight::bench {

namespace {

double bump(double x, double y, double width) { return std::exp(-(x * x + y * y) / (width * width)); }

ShallowWaterSettings scene(int cells, bool shore) {
    ShallowWaterSettings s;
    s.grid = make_grid(cells, cells, 100, 100);
    s.bed_m = Field<double>(cells, cells);
    s.depth_m = Field<double>(cells, cells);
    s.manning = shore ? 0.02 : 0;
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            const double x = s.grid.x_m(i) - 50, y = s.grid.y_m(j) - 50;
            const double bed = shore ? -1 + 2 * bump(x, y, 15) : -1;
            s.bed_m(i, j) = bed;
            s.depth_m(i, j) = std::max(0.0, 0.3 * bump(x + 25, y + 25, 8) - bed);
        }
    }
    return s;
}

void run(benchmark::State& state, const ShallowWaterSettings& settings, const MakeShallow& make) {
    const auto model = make(settings);
    const double frame = 4 * model->step_s();
    model->advance(frame);
    const std::int64_t before = model->steps();
    for (auto _ : state) model->advance(frame);
    const double steps = static_cast<double>(model->steps() - before);
    state.counters["cell_steps_per_s"] =
        benchmark::Counter(steps * static_cast<double>(settings.grid.cells()), benchmark::Counter::kIsRate);
}

}  // namespace

void register_shallow(const std::string& backend, const MakeShallow& make, int frames) {
    for (const int cells : {512, 1024, 2048}) {
        for (const bool shore : {false, true}) {
            const std::string name =
                fmt::format("waves_shallow_water/{}/{}/{}", backend, cells, shore ? "shore" : "wet");
            auto* bench = benchmark::RegisterBenchmark(
                name.c_str(), [=](benchmark::State& state) { run(state, scene(cells, shore), make); });
            bench->Unit(benchmark::kMillisecond)->UseRealTime();
            if (frames > 0) bench->Iterations(frames);
        }
    }
}

}  // namespace waterlight::bench
