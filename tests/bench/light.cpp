// What the light that a scene may ask for costs, beside the plain map: light/CASE, seconds per frame of a map of
// 1024 x 768 pixels over a moving pool.
#include <benchmark/benchmark.h>

#include "caustics/relief.hpp"
#include "caustics/spectral_floor.hpp"
#include "caustics/walls.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight::bench {

namespace {

const Surface& pool() {
    static const Surface surface =
        test::sample(make_grid(512, 384, 8, 6), {Side::wall, Side::wall},
                     test::sines({{.0006, 1, 0}, {.0004, .7, 40}, {.0003, .5, 110}, {.0005, 1.3, 75}}));
    return surface;
}

FloorSettings settings() {
    FloorSettings s;
    s.plan = cover(pool().grid, 1024, 768);
    s.depth_m = 2;
    s.sun.elevation_deg = 60;
    return s;
}

void time(benchmark::State& state, FloorMapper& mapper) {
    FloorMap map;
    mapper.compute(pool(), map);
    for (auto _ : state) mapper.compute(pool(), map);
}

void plain(benchmark::State& state) { time(state, *make_floor_cpu(settings())); }

/// The argument is the radius of the ellipse across the sun's azimuth, in tenths of a pixel.
void sun_disc(benchmark::State& state) {
    const Spread one = disc_spread(settings(), 1);
    const double radius = 2 * std::sqrt(one.yy), wanted = static_cast<double>(state.range(0)) / 10;
    time(state, *make_sun_disc(settings(), wanted / radius, make_floor_cpu));
}

/// Three wavelengths.
void colour(benchmark::State& state) {
    const std::vector<double> nm{650, 550, 450}, shares = black_body_shares(nm);
    std::vector<Band> bands;
    for (std::size_t k = 0; k < nm.size(); ++k) bands.push_back({nm[k], shares[k], optics_at(nm[k], {}, {})});
    SpectralFloor mapper(settings(), bands, make_floor_cpu);
    time(state, mapper);
}

/// All four, in pixels of a centimetre.
void walls(benchmark::State& state) {
    const WallSettings s{.pixel_m = .01, .above_m = .1, .depth_m = 2, .sun = settings().sun, .optics = {}};
    WallMaps maps;
    for (auto _ : state) light_walls(s, pool(), maps);
}

/// Sloping ground.
void ground(benchmark::State& state) {
    ReliefSettings s{settings(), Field<float>(pool().grid.nx, pool().grid.ny)};
    for (int j = 0; j < s.bed_m.ny(); ++j)
        for (int i = 0; i < s.bed_m.nx(); ++i) s.bed_m(i, j) = -2 + 0.002F * static_cast<float>(i);
    time(state, *make_relief_floor(std::move(s)));
}

}  // namespace

BENCHMARK(plain)->Name("light/plain")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(sun_disc)
    ->Name("light/sun_disc/tenths")
    ->Arg(9)
    ->Arg(45)
    ->Arg(160)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

BENCHMARK(colour)->Name("light/colour/3")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(ground)->Name("light/ground")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(walls)->Name("light/walls")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace waterlight::bench
