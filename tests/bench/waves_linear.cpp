// Speed of the linear model: cells times steps per second.
#include <benchmark/benchmark.h>

#include "sim/linear.hpp"

namespace {

void waves_linear(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    waterlight::LinearSettings settings;
    settings.grid = waterlight::make_grid(n, n, 8, 8);
    settings.standing = {{0.01, 4, 6}};
    const auto model = waterlight::make_linear<float>(settings);
    const double frame = 48 * model->step_s();
    for (auto _ : state) model->advance(frame);
    state.counters["cells"] =
        benchmark::Counter(static_cast<double>(model->steps()) * n * n, benchmark::Counter::kIsRate);
}

}  // namespace

BENCHMARK(waves_linear)->Name("waves_linear/cpu")->Arg(256)->Arg(1024)->Arg(4096)->UseRealTime();
