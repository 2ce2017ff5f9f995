// What the machine can do at best, in the same minute as the other benchmarks: bytes to and from memory, and
// multiplications with additions in single precision, on all threads.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <array>
#include <vector>

namespace {

// a = b + 3 c over arrays far larger than the caches: 12 bytes a value.
void memory(benchmark::State& state) {
    const int n = 1 << 26;
    std::vector<float> a(n), b(n, 1.0F), c(n, 2.0F);
    for (auto _ : state) {
        float* __restrict to = a.data();
        const float* __restrict from = b.data();
        const float* __restrict more = c.data();
#pragma omp parallel for schedule(static)
        for (int i = 0; i < n; ++i) to[i] = from[i] + 3 * more[i];
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(state.iterations() * std::int64_t{12} * n);
}

// The widest vectors, and so many independent sums of them that none waits for itself and all have a register.
#if defined(__AVX512F__)
constexpr int vector_bytes = 64, sums = 16;
#elif defined(__AVX__)
constexpr int vector_bytes = 32, sums = 12;
#else
constexpr int vector_bytes = 16, sums = 12;
#endif

void arithmetic(benchmark::State& state) {
    using Vector [[gnu::vector_size(vector_bytes)]] = float;
    constexpr int rounds = 1 << 20;
    const int threads = omp_get_max_threads();
    for (auto _ : state) {
#pragma omp parallel num_threads(threads)
        {
            std::array<Vector, sums> x{};
            Vector factor = Vector{} + 0.999F;
            benchmark::DoNotOptimize(factor);
            for (int r = 0; r < rounds; ++r)
                for (Vector& each : x) each = each * factor + factor;
            for (Vector& each : x) benchmark::DoNotOptimize(each);
        }
    }
    const double each = 2.0 * sums * (sizeof(Vector) / sizeof(float)) * rounds;
    state.counters["flop"] =
        benchmark::Counter(each * threads * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

}  // namespace

BENCHMARK(memory)->Name("roof/memory")->UseRealTime();
BENCHMARK(arithmetic)->Name("roof/arithmetic")->UseRealTime();
