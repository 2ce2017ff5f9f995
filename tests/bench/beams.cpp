// beams_image/BACKEND/N/WIDTHxHEIGHT: one picture of a pool from the side, N x N cells of two beams each, beams made
// anew from the surface in every frame. beams_volume/BACKEND/XxYxZ: both fields of 128 x 128 cells of beams.
#include "tests/bench/beams.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "caustics/beam_image.hpp"
#include "caustics/beam_volume.hpp"
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

void beams_image(benchmark::State& state, int n, int reduction) {
    const Surface surface = pool();
    const BeamSettings settings = beam_settings(n);
    BeamImageSettings picture;
    picture.camera = beside_the_pool();
    picture.optics = settings.optics;
    picture.reduction = reduction;
    Beams beams;
    BeamImage image;
    make_beams(settings, surface, beams);
    draw_beams(picture, beams, image);
    for (auto _ : state) {
        make_beams(settings, surface, beams);
        draw_beams(picture, beams, image);
    }
    state.counters["beams"] = static_cast<double>(image.counts.beams);
    state.counters["covered_pixels"] = static_cast<double>(image.counts.covered_pixels);
    state.counters["sections"] = static_cast<double>(image.counts.sections);
}

void make_only(benchmark::State& state, int n) {
    const Surface surface = pool();
    Beams beams;
    for (auto _ : state) make_beams(beam_settings(n), surface, beams);
}

void beams_volume(benchmark::State& state, glm::ivec3 cells) {
    Beams beams;
    make_beams(beam_settings(128), pool(), beams);
    BeamVolume volume;
    fill_volume(beams, cells, volume);
    for (auto _ : state) fill_volume(beams, cells, volume);
    state.counters["cells_per_s"] =
        benchmark::Counter(double(cells.x) * cells.y * cells.z, benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace

void register_beams() {
    const auto add = [](const std::string& name, auto run) {
        benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond)->UseRealTime();
    };
    for (const int n : {32, 64, 128}) {
        add(fmt::format("beams_image/cpu/{}/900x600", n), [n](benchmark::State& s) { beams_image(s, n, 1); });
        add(fmt::format("beams_make/cpu/{}", n), [n](benchmark::State& s) { make_only(s, n); });
    }
    for (const int reduction : {2, 4})
        add(fmt::format("beams_image_reduced/cpu/128/900x600/{}", reduction),
            [reduction](benchmark::State& s) { beams_image(s, 128, reduction); });
    add("beams_volume/cpu/128x128x128", [](benchmark::State& s) { beams_volume(s, {128, 128, 128}); });
}

}  // namespace waterlight::bench
