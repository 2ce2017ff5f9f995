// Light in the water: fields against the truth, pictures of flat water against their closed form.
#include <fmt/format.h>

#include <algorithm>

#include "caustics/beam_renderer_vulkan.hpp"
#include "caustics/kernels/optics.hpp"
#include "caustics/kernels/phase.hpp"
#include "tests/bench/accuracy/report.hpp"
#include "tests/bench/accuracy/scenes.hpp"

namespace waterlight::accuracy {

namespace {

std::vector<std::unique_ptr<BeamRenderer>> renderers(const Options& options) {
    std::vector<std::unique_ptr<BeamRenderer>> all;
    all.push_back(make_beam_renderer_cpu());
    if (options.context) all.push_back(make_beam_renderer_vulkan(options.context));
    return all;
}

/// One slice of plane irradiance of many periods, as many beams along each side as cells.
struct Slice {
    Grid grid;
    BeamSettings settings;
    Surface surface;
    std::vector<Beams> beams;
    std::vector<BeamVolume> volumes;  ///< by back-end

    Slice(const Scene& scene, double depth_m, int n, int side) : grid(many_periods(scene, n, side)) {
        settings.grid = {grid.nx, grid.ny};
        settings.depth_m = 2 * depth_m;  // the only slice lies in the middle
        settings.sun = scene.sun;
        surface = test::sample(grid, periodic, scene.waves);
    }

    /// Beside the pixel footprint's map at that depth, which is the first.
    std::vector<Timed> measure(const Options& options, const std::vector<std::unique_ptr<BeamRenderer>>& backends) {
        FloorSettings floor;
        floor.plan = cover(grid, grid.nx, grid.ny);
        floor.footprint = Footprint::pixel;
        floor.depth_m = 0.5 * settings.depth_m;
        floor.sun = settings.sun;
        const auto mapper = make_floor_cpu(floor);
        FloorMap map;
        beams.resize(backends.size());
        volumes.resize(backends.size());
        std::vector<std::function<void()>> works{[&] { mapper->compute(surface, map); }};
        for (std::size_t k = 0; k < backends.size(); ++k) {
            works.emplace_back([&, k] {
                make_beams(settings, surface, beams[k]);
                backends[k]->fill(beams[k], {grid.nx, grid.ny, 1}, volumes[k]);
            });
        }
        return time_together(options, works, options.quick ? .05 : .8);
    }
};

void report_slices(const Options& options, Choices& choices) {
    const Scene scene = frozen_sine(.01);
    const double focus = first_focus_m(scene);
    const auto backends = renderers(options);
    fmt::print(
        R"(
### Plane irradiance on slices

The sine, one slice of {0} x {0} cells, as many columns and rows of beams as of cells, against the truth. Times are of making
the beams and filling the slice, as multiples of the floor map with `pixel` at that depth.
)",
        map_side(options));
    std::vector<std::string> heads{"depth", "columns a wave", "RMSE", "RMSE in 4 columns", "pixel cpu, ms", "cpu"};
    if (options.context) heads.emplace_back("vulkan");
    print_heads(heads);
    for (const auto& [factor, words] : {std::pair{.5, "half the focus"}, {1.0, "at it"}, {2.0, "twice"}}) {
        const TruthMap fine = fine_truth(scene, factor * focus);
        std::vector<int> resolutions;
        std::vector<double> errors, boxes;
        for (int n = 16; n <= (options.quick ? 64 : 256); n *= 2) {
            Slice slice(scene, factor * focus, n, map_side(options));
            const std::vector<Timed> times = slice.measure(options, backends);
            const Field<double> truth = truth_at_pixels(scene, fine, n);
            const auto error = [&](const BeamVolume& volume, int box) {
                return relative_rms(box_means(volume.plane_irradiance, box, 1), box_means(truth, box, 1));
            };
            resolutions.push_back(n);
            errors.push_back(error(slice.volumes[0], 1));
            boxes.push_back(error(slice.volumes[0], 4));
            std::vector<std::string> cells{words, std::to_string(n), percent(errors.back()), percent(boxes.back()),
                                           fmt::format("{:.2f}", times[0].ms)};
            const double area = slice.grid.width_m() * slice.grid.height_m();
            for (std::size_t k = 0; k < backends.size(); ++k) {
                cells.push_back(digits(times[k + 1].ratio));
                choices.add(fmt::format("beams, slice of the sine, {}", words),
                            {fmt::format("{} columns, {}", n, backends[k]->backend()), error(slice.volumes[k], n / 16),
                             times[k + 1].pixels * wave_m * wave_m / area});
            }
            print_row(cells);
        }
        std::vector<std::string> cells{words, "order", fmt::format("{:.2f}", order_of(resolutions, errors)),
                                       fmt::format("{:.2f}", order_of(resolutions, boxes))};
        cells.resize(heads.size());
        print_row(cells);
    }
}

/// Flat water 10 m long and 4 m deep between walls, b = .05, c = .15 1/m, E0 = 1 W/m2, the sun overhead.
struct FlatPool {
    BeamSettings settings;
    BeamImageSettings picture;
    Surface surface = test::sample(make_grid(40, 40, 10, 10), {Side::wall, Side::wall}, test::flat);

    explicit FlatPool(int n) {
        settings.grid = {n, n};
        settings.depth_m = 4;
        settings.sun = {90, 0, 1};
        settings.optics.absorption_per_m = .1;
        settings.optics.scattering_per_m = .05;
        picture.optics = settings.optics;
        picture.camera = {{.4, 1.3, -.7}, {9, 8, -2.6}, 50, {180, 120}};
    }

    /// b p(angle) E_n exp(-c d0 / mu_s) (1 - exp(-kappa S)) / kappa, kappa = c (1 + mu / mu_s), S to the water's end.
    double law(int i, int j) const {
        const Camera& c = picture.camera;
        const glm::dvec3 r = glm::normalize(c.rays().at(i, j));
        const double way =
            std::min({((r.x > 0 ? 10 : 0) - c.position_m.x) / r.x, ((r.y > 0 ? 10 : 0) - c.position_m.y) / r.y,
                      ((r.z < 0 ? -settings.depth_m : 0) - c.position_m.z) / r.z});
        const f64::Refraction f = f64::refract_sun(settings.sun.direction(), {0, 0}, 4.0 / 3, 1);
        const glm::dvec3 light = glm::dvec3{f.travel.x, f.travel.y, -1} / f.path;
        const double extinction = settings.optics.extinction_per_m();
        const double kappa = extinction * (1 - r.z * f.path);
        return settings.optics.scattering_per_m * f64::henyey_greenstein(.9, -glm::dot(light, r)) * f.incident *
               f.transmittance * f.path * std::exp(extinction * c.position_m.z * f.path) *
               (1 - std::exp(-kappa * way)) / kappa;
    }

    Field<double> law() const {
        Field<double> all(picture.camera.size.x, picture.camera.size.y);
        for (int j = 0; j < all.ny(); ++j)
            for (int i = 0; i < all.nx(); ++i) all(i, j) = law(i, j);
        return all;
    }
};

void report_pictures(const Options& options, Choices& choices) {
    const auto backends = renderers(options);
    fmt::print(
        R"(
### Pictures of flat water

A pool of 10 x 10 x 4 m seen off its axis, 180 x 120 pixels, against the closed form of single scatter; beams made anew.
Vulkan's time is a multiple of the CPU's.
)");
    std::vector<std::string> heads{"cells of beams", "RMSE cpu", "cpu, ms"};
    if (options.context) heads.insert(heads.end(), {"RMSE vulkan", "vulkan"});
    print_heads(heads);
    for (const int n : {8, 16, 32, 64}) {
        if (options.quick && n > 16) continue;
        const FlatPool pool(n);
        const Field<double> law = pool.law();
        std::vector<Beams> beams(backends.size());
        std::vector<BeamImage> images(backends.size());
        std::vector<std::function<void()>> works;
        for (std::size_t k = 0; k < backends.size(); ++k) {
            works.emplace_back([&, k] {
                make_beams(pool.settings, pool.surface, beams[k]);
                backends[k]->draw(pool.picture, beams[k], images[k]);
            });
        }
        const std::vector<Timed> times = time_together(options, works, .5);
        std::vector<std::string> cells{fmt::format("{} x {}", n, n)};
        for (std::size_t k = 0; k < backends.size(); ++k) {
            const double error = relative_rms(box_means(images[k].radiance, 1, 1), law);
            cells.push_back(percent(error));
            cells.push_back(k == 0 ? fmt::format("{:.2f}", times[k].ms) : digits(times[k].ratio));
            choices.add("picture of flat water (thousands a picture)",
                        {fmt::format("{} x {}, {}", n, n, backends[k]->backend()), error, 1e-3 * times[k].pixels});
        }
        print_row(cells);
    }
}

}  // namespace

void report_beams(const Options& options, Choices& choices) {
    fmt::print("\n## Light in the water\n");
    report_slices(options, choices);
    report_pictures(options, choices);
}

}  // namespace waterlight::accuracy
