// beams_image/BACKEND/N/WIDTHxHEIGHT: one picture of a pool from the side, N x N cells of two beams each, beams made
// anew from the surface in every frame. beams_volume/BACKEND/XxYxZ: both fields of 128 x 128 cells of beams.
#include "tests/bench/beams.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <map>

#include "tests/support/surfaces.hpp"

namespace waterlight::bench {

namespace {

/// A pool of 3 x 3 m, 2 m deep, with waves that focus in it.
Surface pool() {
    const Grid grid = make_grid(256, 256, 3, 3);
    return test::sample(grid, {Side::wall, Side::wall},
                        test::sines({{.008, .75, 0}, {.006, .6, 50}, {.005, .5, 110}, {.004, .43, 75}}));
}

BeamSettings beam_settings(int n) {
    BeamSettings s;
    s.grid = {n, n};
    s.depth_m = 2;
    s.sun = {70, 40, 1000};
    s.optics.absorption_per_m = .1;
    s.optics.scattering_per_m = .05;
    return s;
}

/// The pool fills some two fifths of the picture.
Camera beside_the_pool() { return {{1.5, -3.2, -.8}, {1.5, 1.5, -1}, 50, {900, 600}}; }

/// Mean time of the back-end's own stages, where it keeps them.
void count_stages(benchmark::State& state, const std::map<std::string, double>& seconds) {
    for (const auto& [stage, s] : seconds)
        state.counters[stage + "_ms"] = benchmark::Counter(1e3 * s, benchmark::Counter::kAvgIterations);
}

void beams_image(benchmark::State& state, BeamRenderer& renderer, int n, int reduction) {
    const Surface surface = pool();
    const BeamSettings settings = beam_settings(n);
    BeamImageSettings picture;
    picture.camera = beside_the_pool();
    picture.optics = settings.optics;
    picture.reduction = reduction;
    Beams beams;
    BeamImage image;
    make_beams(settings, surface, beams);
    renderer.draw(picture, beams, image);
    std::map<std::string, double> stages;
    for (auto _ : state) {
        make_beams(settings, surface, beams);
        renderer.draw(picture, beams, image);
        for (const StageTime& t : renderer.stage_times()) stages[t.stage] += t.seconds;
    }
    count_stages(state, stages);
    state.counters["beams"] = static_cast<double>(image.counts.beams);
    state.counters["covered_pixels"] = static_cast<double>(image.counts.covered_pixels);
    if (image.counts.sections > 0) state.counters["sections"] = static_cast<double>(image.counts.sections);
}

void make_only(benchmark::State& state, int n) {
    const Surface surface = pool();
    Beams beams;
    for (auto _ : state) make_beams(beam_settings(n), surface, beams);
}

void beams_volume(benchmark::State& state, BeamRenderer& renderer, glm::ivec3 cells) {
    Beams beams;
    make_beams(beam_settings(128), pool(), beams);
    BeamVolume volume;
    renderer.fill(beams, cells, volume);
    std::map<std::string, double> stages;
    for (auto _ : state) {
        renderer.fill(beams, cells, volume);
        for (const StageTime& t : renderer.stage_times()) stages[t.stage] += t.seconds;
    }
    count_stages(state, stages);
    state.counters["cells_per_s"] =
        benchmark::Counter(double(cells.x) * cells.y * cells.z, benchmark::Counter::kIsIterationInvariantRate);
}

template <class Run>
void add(const std::string& name, Run run) {
    benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond)->UseRealTime();
}

}  // namespace

void register_beams(const std::string& backend, const MakeRenderer& make) {
    for (const int n : {32, 64, 128})
        add(fmt::format("beams_image/{}/{}/900x600", backend, n),
            [n, make](benchmark::State& s) { beams_image(s, *make(), n, 1); });
    add(fmt::format("beams_volume/{}/128x128x128", backend), [make](benchmark::State& s) {
        beams_volume(s, *make(), {128, 128, 128});
    });
}

void register_beam_parts() {
    for (const int n : {32, 64, 128})
        add(fmt::format("beams_make/cpu/{}", n), [n](benchmark::State& s) { make_only(s, n); });
    for (const int reduction : {2, 4})
        add(fmt::format("beams_image_reduced/cpu/128/900x600/{}", reduction),
            [reduction](benchmark::State& s) { beams_image(s, *make_beam_renderer_cpu(), 128, reduction); });
}

}  // namespace waterlight::bench
