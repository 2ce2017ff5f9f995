// What a checkpoint costs: the run waits while the state is collected, the thread that writes while it goes to the
// disk.
#include <benchmark/benchmark.h>

#include <filesystem>

#include "export/checkpoint_file.hpp"
#include "sim/airy.hpp"
#include "sim/linear.hpp"
#include "sim/shallow_water.hpp"

namespace {

using namespace waterlight;

std::unique_ptr<WaveModel> linear(const Grid& grid) {
    LinearSettings settings;
    settings.grid = grid;
    return make_linear<float>(settings);
}

std::unique_ptr<WaveModel> airy(const Grid& grid) {
    AirySettings settings;
    settings.grid = grid;
    return make_airy(settings);
}

std::unique_ptr<WaveModel> shallow_water(const Grid& grid) {
    ShallowWaterSettings settings;
    settings.grid = grid;
    settings.keep_records = true;
    return make_shallow_water<float>(settings);
}

template <class Make>
void checkpoint(benchmark::State& state, Make make, bool writes) {
    const int n = static_cast<int>(state.range(0));
    const auto model = make(make_grid(n, n, 8, 8));
    const std::filesystem::path path = std::filesystem::temp_directory_path() / "waterlight_bench_checkpoint.bin";
    StateArchive kept;
    model->exchange_state(kept);
    for (auto _ : state) {
        if (writes) {
            write_checkpoint(path, kept.parts());
        } else {
            StateArchive archive;
            model->exchange_state(archive);
            benchmark::DoNotOptimize(archive.bytes());
        }
    }
    state.counters["bytes_per_cell"] = static_cast<double>(kept.bytes()) / n / n;
    std::filesystem::remove(path);
}

}  // namespace

BENCHMARK_CAPTURE(checkpoint, collect_linear, linear, false)->Arg(1024)->UseRealTime();
BENCHMARK_CAPTURE(checkpoint, collect_airy, airy, false)->Arg(1024)->UseRealTime();
BENCHMARK_CAPTURE(checkpoint, collect_shallow_water, shallow_water, false)->Arg(1024)->UseRealTime();
BENCHMARK_CAPTURE(checkpoint, write_linear, linear, true)->Arg(1024)->UseRealTime();
BENCHMARK_CAPTURE(checkpoint, write_airy, airy, true)->Arg(1024)->UseRealTime();
BENCHMARK_CAPTURE(checkpoint, write_shallow_water, shallow_water, true)->Arg(1024)->UseRealTime();
