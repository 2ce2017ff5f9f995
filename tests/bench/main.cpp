// Benchmarks by Google Benchmark: waterlight_bench --benchmark_filter=floor_two_pass/cpu
#include <benchmark/benchmark.h>

#include "tests/bench/floor_two_pass.hpp"

int main(int argc, char** argv) {
    waterlight::bench::register_floor("cpu", waterlight::make_floor_cpu);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
