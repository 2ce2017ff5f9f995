// The sun's disc and colour against the truth of many suns and of each wavelength.
#include <fmt/format.h>

#include <algorithm>

#include "caustics/spectral_floor.hpp"
#include "tests/bench/accuracy/report.hpp"
#include "tests/bench/accuracy/scenes.hpp"
#include "tests/support/sun_points.hpp"

namespace waterlight::accuracy {

namespace {

constexpr double sun_deg = 0.2665;

double brightest(const Field<double>& field) { return *std::max_element(field.values().begin(), field.values().end()); }

FloorSettings settings_of(const Scene& scene, const Grid& grid, double depth_m) {
    FloorSettings s;
    s.plan = cover(grid, grid.nx, grid.ny);
    s.depth_m = depth_m;
    s.sun = scene.sun;
    return s;
}

/// The sum of the truths of suns along the disc's diameter, each of its chord: the whole disc to waves along x.
Field<double> truth_of_the_disc(const Scene& scene, double depth_m, int p, int suns) {
    const Grid line = make_grid(p, 1, scene.period_m.x, scene.period_m.x / p);
    TruthSettings t;
    t.floor = settings_of(scene, line, depth_m);
    t.subsamples = 4;
    t.most_subsamples = 8;
    return test::truth_of(test::sun_chords(sun_deg, suns), t, test::as_truth(line, periodic, scene.waves));
}

/// Of the disc on the floor below flat water, the sun overhead.
double disc_radius_m(double depth_m) {
    FloorSettings s;
    s.plan = cover(make_grid(1, 1, 1, 1), 1000, 1000);
    s.depth_m = depth_m;
    return 2 * std::sqrt(disc_spread(s, sun_deg).xx) / 1000;
}

void report_disc(const Options& options) {
    const Scene scene = frozen_sine(.01);
    const double depth = first_focus_m(scene);
    const int finest = options.quick ? 64 : 256, suns = options.quick ? 40 : 120;
    fmt::print(
        R"(
### The sun's disc

The sine at its focus, {:.3f} m, half-angle {} degrees: the adaptive map, convolved, against the truth of {} suns. Peaks are
of pixel averages, E0 = 1 W/m2. On the floor the disc's radius is {:.2g} m.
)",
        depth, sun_deg, suns, disc_radius_m(depth));
    const Field<double> fine = truth_of_the_disc(scene, depth, finest, suns);
    print_heads({"pixels", "RMSE", "without the disc", "peak", "of the suns", "times the map without"});
    for (int p = finest; p >= 32; p /= 2) {
        const Grid grid = many_periods(scene, p, map_side(options));
        const Surface surface = test::sample(grid, periodic, scene.waves);
        const FloorSettings s = settings_of(scene, grid, depth);
        const auto plain = make_floor_cpu(s), disc = make_sun_disc(s, sun_deg, make_floor_cpu);
        FloorMap sharp, soft;
        const auto times = time_together(
            options, {[&] { plain->compute(surface, sharp); }, [&] { disc->compute(surface, soft); }}, .5);
        const Field<double> truth = box_means(fine, finest / p, 1), map = box_means(soft.irradiance, 1, 1);
        print_row({std::to_string(p), percent(relative_rms(map, truth)),
                   percent(relative_rms(box_means(sharp.irradiance, 1, 1), truth)),
                   fmt::format("{:.3f}", brightest(map)), fmt::format("{:.3f}", brightest(truth)),
                   fmt::format("{:.2f}", times[1].ratio)});
    }
}

std::vector<Band> three_bands() {
    const std::vector<double> nm{650, 550, 450}, shares = black_body_shares(nm);
    std::vector<Band> bands;
    for (std::size_t k = 0; k < nm.size(); ++k) bands.push_back({nm[k], shares[k], optics_at(nm[k], {}, {})});
    return bands;
}

void report_colour(const Options& options) {
    Scene scene = frozen_sine(.01);
    scene.sun.elevation_deg = 45;
    const double depth = 0.5 * first_focus_m(scene);
    const int finest = options.quick ? 64 : 256;
    fmt::print(
        R"(
### Colour

The sine at {:.3f} m, half its focus, sun at 45 degrees, three wavelengths in fresh water.
)",
        depth);
    print_heads({"pixels", "650 nm", "550 nm", "450 nm", "times one map"});
    for (int p = 32; p <= finest; p *= 2) {
        const Grid grid = many_periods(scene, p, map_side(options)), line = make_grid(p, 1, wave_m, wave_m / p);
        const Surface surface = test::sample(grid, periodic, scene.waves);
        const FloorSettings s = settings_of(scene, grid, depth);
        const auto plain = make_floor_cpu(s);
        SpectralFloor colour(s, three_bands(), make_floor_cpu);
        FloorMap one, sum;
        const auto times =
            time_together(options, {[&] { plain->compute(surface, one); }, [&] { colour.compute(surface, sum); }}, .5);
        std::vector<std::string> cells{std::to_string(p)};
        for (const BandMap& band : colour.maps()) {
            TruthSettings t;
            t.floor = settings_of(scene, line, depth);
            t.floor.sun.irradiance_w_m2 *= band.band.share;
            t.floor.optics = band.band.optics;
            t.subsamples = 16;
            t.tolerance = 1e-5;
            const TruthMap truth = truth_map(t, test::as_truth(line, periodic, scene.waves));
            cells.push_back(percent(relative_rms(box_means(band.map.irradiance, 1, 1), truth.irradiance)));
        }
        cells.push_back(fmt::format("{:.2f}", times[1].ratio));
        print_row(cells);
    }
}

}  // namespace

void report_light(const Options& options) {
    fmt::print("\n## The sun's disc and colour\n\nTheir laws are in [light.md](light.md).\n");
    report_disc(options);
    report_colour(options);
}

}  // namespace waterlight::accuracy
