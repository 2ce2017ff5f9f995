// Benchmarks by Google Benchmark: waterlight_bench --benchmark_filter=floor_two_pass/cpu
#include <benchmark/benchmark.h>

#include <cstdio>

#include "caustics/beam_renderer_vulkan.hpp"
#include "caustics/floor_vulkan.hpp"
#include "caustics/splat/splat_vulkan.hpp"
#include "gpu/error.hpp"
#include "sim/shallow_water_vulkan.hpp"
#include "tests/bench/beams.hpp"
#include "tests/bench/floor_two_pass.hpp"
#include "tests/bench/frame.hpp"
#include "tests/bench/waves_shallow_water.hpp"

namespace {

using namespace waterlight;

/// The Vulkan cases, on the best device there is; none without a device.
void register_vulkan() {
    try {
        auto context = std::make_shared<gpu::Context>();
        benchmark::AddCustomContext("vulkan_device", context->device().name);
        bench::register_floor("vulkan", [context](const FloorSettings& s) { return make_floor_vulkan(s, context); });
        bench::register_floor_splat("vulkan",
                                    [context](const SplatSettings& s) { return make_splat_floor_vulkan(s, context); });
        // A program that plays a GPU takes seconds for a few steps.
        const int frames = context->device().type == gpu::DeviceType::cpu ? 1 : 0;
        bench::register_shallow(
            "vulkan", [context](const ShallowWaterSettings& s) { return make_shallow_water_vulkan(s, context); },
            frames);
        bench::register_beams("vulkan", [context] { return make_beam_renderer_vulkan(context); });
        bench::register_frames(context);
    } catch (const gpu::Error& error) {
        std::fprintf(stderr, "no vulkan cases: %s\n", error.what());
    }
}

}  // namespace

int main(int argc, char** argv) {
    bench::register_floor("cpu", make_floor_cpu);
    bench::register_floor_quads();
    bench::register_floor_photons();
    bench::register_floor_splat("cpu", make_splat_floor_cpu);
    bench::register_shallow("cpu", make_shallow_water<float>);
    bench::register_beams("cpu", make_beam_renderer_cpu);
    bench::register_beam_parts();
    register_vulkan();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
