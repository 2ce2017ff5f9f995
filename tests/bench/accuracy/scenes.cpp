#include "tests/bench/accuracy/scenes.hpp"

#include "caustics/kernels/optics.hpp"
#include "tests/bench/accuracy/report.hpp"

namespace waterlight::accuracy {

Scene frozen_sine(double amplitude_m) {
    return {.name = "sine",
            .waves = test::sines({{amplitude_m, wave_m, 0}}),
            .period_m = {wave_m, wave_m},
            .aspect = 0,
            .finest = 512};
}

Scene egg_crate() {
    return {.name = "egg-crate", .waves = test::egg_crate(.006, wave_m), .period_m = {wave_m, wave_m}};
}

Scene crossed_waves() {
    const double period = std::sqrt(2.0) * wave_m;
    return {.name = "crossed waves",
            .waves = test::sines({{.005, wave_m, 45}, {.004, wave_m, 135}}),
            .period_m = {period, period}};
}

Scene skew_wave() {
    return {.name = "skew wave",
            .waves = test::sines({{.01, wave_m, 30}}),
            .period_m = {2 * wave_m / std::sqrt(3.0), 2 * wave_m},
            .sun = {45, 0, 1},
            .aspect = 4,
            .finest = 128};
}

namespace {

/// Where the ray that enters at `at` crosses the depth.
glm::dvec2 landing(const Scene& scene, glm::dvec2 at, double depth_m) {
    const SurfacePoint p = scene.waves(at);
    const auto ray = f64::refract_sun(scene.sun.direction(), p.slope, WaterOptics{}.refractive_index, 1);
    return at + (p.elevation_m + depth_m) * glm::dvec2(ray.travel.x, ray.travel.y);
}

double determinant(const Scene& scene, glm::dvec2 at, double depth_m) {
    const double h = 1e-4 * wave_m;
    const auto across = [&](glm::dvec2 step) {
        return (landing(scene, at + step, depth_m) - landing(scene, at - step, depth_m)) / (2 * h);
    };
    const glm::dvec2 x = across({h, 0}), y = across({0, h});
    return x.x * y.y - x.y * y.x;
}

/// The smallest positive root of c + b D + a D^2; infinity where there is none.
double smallest_root(double a, double b, double c) {
    const double under = b * b - 4 * a * c;
    double least = std::numeric_limits<double>::infinity();
    if (under < 0) return least;
    const double q = -0.5 * (b + std::copysign(std::sqrt(under), b));
    for (const double root : {q / a, c / q})
        if (std::isfinite(root) && root > 0) least = std::min(least, root);
    return least;
}

}  // namespace

double first_focus_m(const Scene& scene) {
    constexpr int places = 96;
    double least = std::numeric_limits<double>::infinity();
    for (int j = 0; j < places; ++j) {
        for (int i = 0; i < places; ++i) {
            const glm::dvec2 at = scene.period_m * glm::dvec2(i, j) / double(places);
            const double d0 = determinant(scene, at, 0), d1 = determinant(scene, at, 1), d2 = determinant(scene, at, 2);
            const double a = 0.5 * (d2 - 2 * d1 + d0);
            least = std::min(least, smallest_root(a, d1 - d0 - a, d0));
        }
    }
    return least;
}

TruthMap fine_truth(const Scene& scene, double depth_m) {
    const int nx = scene.finest, ny = scene.aspect > 0 ? scene.aspect * nx : 1;
    const double height = scene.aspect > 0 ? scene.period_m.y : scene.period_m.x / nx;
    const Grid grid = make_grid(nx, ny, scene.period_m.x, height);
    TruthSettings t;
    t.floor.plan = cover(grid, nx, ny);
    t.floor.depth_m = depth_m;
    t.floor.sun = scene.sun;
    t.subsamples = scene.aspect > 0 ? 4 : 16;
    t.most_subsamples = 2 * t.subsamples;
    return truth_map(t, test::as_truth(grid, periodic, scene.waves));
}

Field<double> truth_at_pixels(const Scene& scene, const TruthMap& fine, int p) {
    const int box = scene.finest / p;
    return box_means(fine.irradiance, box, scene.aspect > 0 ? box : 1);
}

std::function<void()> make_yardstick() {
    struct Yardstick {
        Surface surface;
        std::unique_ptr<FloorMapper> mapper;
        FloorMap map;
    };
    const Scene scene = frozen_sine(.01);
    const Grid grid = many_periods(scene, 64, 256);
    FloorSettings s;
    s.plan = cover(grid, grid.nx, grid.ny);
    s.footprint = Footprint::pixel;
    s.sun = scene.sun;
    auto all = std::make_shared<Yardstick>(
        Yardstick{test::sample(grid, periodic, scene.waves), make_floor_cpu(s), FloorMap{}});
    return [all] { all->mapper->compute(all->surface, all->map); };
}

Grid many_periods(const Scene& scene, int p, int side) {
    const auto copies = [side](int pixels) { return (side + pixels - 1) / pixels; };
    const int nx = p * copies(p);
    const double width = scene.period_m.x * copies(p);
    if (scene.aspect == 0) return make_grid(nx, side, width, side * scene.period_m.x / p);
    const int rows = scene.aspect * p;
    return make_grid(nx, rows * copies(rows), width, scene.period_m.y * copies(rows));
}

}  // namespace waterlight::accuracy
