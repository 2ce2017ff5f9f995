// beams_image/BACKEND/N/WIDTHxHEIGHT: one picture of a pool from the side, N x N cells of two beams each, beams made
// anew from the surface in every frame. beams_volume/BACKEND/XxYxZ: both fields of 128 x 128 cells of beams.
#include "tests/bench/beams.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
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

void beams_image(benchmark::State& state, BeamRenderer& renderer, int n) {
    const Surface surface = pool();
    const BeamSettings settings = beam_settings(n);
    BeamImageSettings picture;
    picture.camera = beside_the_pool();
    picture.optics = settings.optics;
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

/// RMS of the difference over that of the full picture.
double error_of(const BeamImage& image, const BeamImage& full) {
    double difference = 0, sum = 0;
    for (std::size_t i = 0; i < full.radiance.size(); ++i) {
        const double f = full.radiance.data()[i], d = image.radiance.data()[i] - f;
        difference += d * d;
        sum += f * f;
    }
    return std::sqrt(difference / sum);
}

/// A cheaper picture beside the full one of the same frame: counters `error` (relative RMSE), `saving` (the part of the
/// full one's time that it does without) and the rays through cells of both. One frame after the other is timed, full
/// and cheap in turn, so that a slow minute slows both.
template <class Cheap>
void compare(benchmark::State& state, int full_grid, Cheap cheap) {
    using Clock = std::chrono::steady_clock;
    const Surface surface = pool();
    const BeamSettings settings = beam_settings(full_grid);
    BeamImageSettings picture;
    picture.camera = beside_the_pool();
    picture.optics = settings.optics;
    Beams beams;
    BeamImage full, image;
    double full_s = 0, cheap_s = 0;
    for (auto _ : state) {
        const Clock::time_point start = Clock::now();
        make_beams(settings, surface, beams);
        draw_beams(picture, beams, full);
        const Clock::time_point middle = Clock::now();
        cheap(surface, picture, image);
        cheap_s += std::chrono::duration<double>(Clock::now() - middle).count();
        full_s += std::chrono::duration<double>(middle - start).count();
        state.SetIterationTime(std::chrono::duration<double>(Clock::now() - middle).count());
    }
    state.counters["error"] = error_of(image, full);
    state.counters["saving"] = 1 - cheap_s / full_s;
    state.counters["sections"] = static_cast<double>(image.counts.sections);
    state.counters["sections_of_full"] = static_cast<double>(full.counts.sections);
}

void reduced(benchmark::State& state, int reduction) {
    Beams beams;
    compare(state, 128, [&](const Surface& surface, BeamImageSettings picture, BeamImage& image) {
        picture.reduction = reduction;
        make_beams(beam_settings(128), surface, beams);
        draw_beams(picture, beams, image);
    });
}

/// A grid of half the cells, refined where light converges, against the full grid.
void refined(benchmark::State& state, double share) {
    RefinedBeams beams;
    compare(state, 128, [&](const Surface& surface, const BeamImageSettings& picture, BeamImage& image) {
        make_refined_beams(beam_settings(64), share, surface, beams);
        draw_beams(picture, beams, image);
    });
}

/// The same grid of half the cells without refining.
void coarse(benchmark::State& state) {
    Beams beams;
    compare(state, 128, [&](const Surface& surface, const BeamImageSettings& picture, BeamImage& image) {
        make_beams(beam_settings(64), surface, beams);
        draw_beams(picture, beams, image);
    });
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
            [n, make](benchmark::State& s) { beams_image(s, *make(), n); });
    add(fmt::format("beams_volume/{}/128x128x128", backend), [make](benchmark::State& s) {
        beams_volume(s, *make(), {128, 128, 128});
    });
}

void register_beam_parts() {
    for (const int n : {32, 64, 128})
        add(fmt::format("beams_make/cpu/{}", n), [n](benchmark::State& s) { make_only(s, n); });
    const auto add_timed = [](const std::string& name, auto run) {
        benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond)->UseManualTime();
    };
    for (const int reduction : {2, 3, 4})
        add_timed(fmt::format("beams_image_reduced/cpu/128/900x600/{}", reduction),
                  [reduction](benchmark::State& s) { reduced(s, reduction); });
    for (const double share : {.5, .7, .9})
        add_timed(fmt::format("beams_image_refined/cpu/64/900x600/{}", share),
                  [share](benchmark::State& s) { refined(s, share); });
    add_timed("beams_image_coarse/cpu/64/900x600", coarse);
}

}  // namespace waterlight::bench
