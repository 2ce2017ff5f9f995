// Waves over a flat floor: every method against the truth at several resolutions.
#include <fmt/format.h>

#include <cmath>

#include "tests/bench/accuracy/scenes.hpp"
#include "tests/bench/methods/methods.hpp"
#include "tests/bench/methods/report.hpp"

namespace waterlight::methods {

namespace {

using accuracy::Scene;

FloorSettings settings_of(const Scene& scene, const Grid& grid, double depth_m) {
    FloorSettings s;
    s.plan = cover(grid, grid.nx, grid.ny);
    s.depth_m = depth_m;
    s.sun = scene.sun;
    return s;
}

double sum_of(const Field<double>& field) {
    double sum = 0;
    for (const double value : field.values()) sum += value;
    return sum;
}

/// Of periods p pixels wide, by every method: relative RMSE over one, and light on the map over the truth's less one.
struct Errors {
    std::vector<double> rmse, energy;
};

constexpr int least_pixels = 64;      ///< of a map's sides: what crosses its rim is a small part
constexpr int cells_along_pixel = 4;  ///< of the surface, so that what is between its cells does not count

Errors errors_of(const Scene& scene, double depth_m, const Field<double>& truth, int p) {
    const Grid pixels = accuracy::many_periods(scene, p, least_pixels);
    const Grid cells =
        make_grid(cells_along_pixel * pixels.nx, cells_along_pixel * pixels.ny, pixels.width_m(), pixels.height_m());
    const Surface surface = test::sample(cells, accuracy::periodic, scene.waves);
    const double truly = sum_of(truth) / static_cast<double>(truth.size());
    Errors errors;
    for (const Method& method : all_methods()) {
        FloorMap map;
        method.make(settings_of(scene, pixels, depth_m), 1)(surface, map);
        const Field<double> found = accuracy::box_means(map.irradiance, 1, 1);
        errors.rmse.push_back(accuracy::relative_rms(found, truth));
        errors.energy.push_back(sum_of(found) / static_cast<double>(found.size()) / truly - 1);
    }
    return errors;
}

void report_scene(const Options& options, const Scene& scene, double depth_m) {
    const TruthMap fine = accuracy::fine_truth(scene, depth_m);
    const int coarsest = 16, finest = options.common.quick ? 64 : scene.finest;
    std::vector<int> resolutions;
    std::vector<Errors> all;
    for (int p = coarsest; p <= finest; p *= 2) {
        resolutions.push_back(p);
        all.push_back(errors_of(scene, depth_m, accuracy::truth_at_pixels(scene, fine, p), p));
    }
    const double focus = accuracy::first_focus_m(scene);
    fmt::print(
        "\n### {}, {:g} m deep\n\nRays first meet at {:.2f} m. The truth's own estimate of its error is {} at its "
        "finest.\n",
        scene.name, depth_m, focus, accuracy::percent(fine.error_estimate));
    std::vector<std::string> heads{"pixels"};
    const std::vector<Method> methods = all_methods();
    for (const Method& m : methods) heads.push_back(m.name);
    accuracy::print_heads(heads);
    for (std::size_t k = 0; k < all.size(); ++k) {
        std::vector<std::string> cells{std::to_string(resolutions[k])};
        for (const double e : all[k].rmse) cells.push_back(accuracy::percent(e));
        accuracy::print_row(cells);
    }
    std::vector<std::string> orders{"order"}, light{"light - 1, at most"};
    for (std::size_t m = 0; m < methods.size(); ++m) {
        std::vector<double> errors;
        double worst = 0;
        for (const Errors& e : all) {
            errors.push_back(e.rmse[m]);
            worst = std::max(worst, std::abs(e.energy[m]));
        }
        orders.push_back(fmt::format("{:.2f}", accuracy::order_of(resolutions, errors)));
        light.push_back(fmt::format("{:.1e}", worst));
    }
    accuracy::print_row(orders);
    accuracy::print_row(light);
}

void report_photon_numbers(const Options& options) {
    constexpr int p = 64;
    const Scene scene = accuracy::egg_crate();
    fmt::print(
        "\n### Photons by their number\n\nThe egg-crate on {0} x {0} pixels; `order` is against the photons along an "
        "axis. What blur hides of noise it adds in blur.\n",
        p);
    accuracy::print_heads({"depth, m", "photons a pixel", "RMSE", "blurred", "RMSE in 4 x 4", "light - 1"});
    const Grid pixels = make_grid(p, p, scene.period_m.x, scene.period_m.y);
    const Surface surface =
        test::sample(make_grid(cells_along_pixel * p, cells_along_pixel * p, scene.period_m.x, scene.period_m.y),
                     accuracy::periodic, scene.waves);
    for (const double depth : {3.0, 8.0}) {
        const Field<double> truth = accuracy::truth_at_pixels(scene, accuracy::fine_truth(scene, depth), p);
        const FloorSettings settings = settings_of(scene, pixels, depth);
        std::vector<int> numbers;
        std::vector<double> errors, blurred_errors, boxes;
        for (int along = 1; along <= (options.common.quick ? 8 : 32); along *= 2) {
            FloorMap map, blurred;
            photons(settings, along, 0)(surface, map);
            photons(settings, along, photon_blur)(surface, blurred);
            const Field<double> found = accuracy::box_means(map.irradiance, 1, 1);
            numbers.push_back(along);
            errors.push_back(accuracy::relative_rms(found, truth));
            blurred_errors.push_back(accuracy::relative_rms(accuracy::box_means(blurred.irradiance, 1, 1), truth));
            boxes.push_back(accuracy::relative_rms(accuracy::box_means(found, 4, 4), accuracy::box_means(truth, 4, 4)));
            accuracy::print_row({fmt::format("{:g}", depth), std::to_string(along * along),
                                 accuracy::percent(errors.back()), accuracy::percent(blurred_errors.back()),
                                 accuracy::percent(boxes.back()),
                                 fmt::format("{:+.1e}", sum_of(found) / sum_of(truth) - 1)});
        }
        accuracy::print_row({fmt::format("{:g}", depth), "order",
                             fmt::format("{:.2f}", accuracy::order_of(numbers, errors)),
                             fmt::format("{:.2f}", accuracy::order_of(numbers, blurred_errors)),
                             fmt::format("{:.2f}", accuracy::order_of(numbers, boxes)), ""});
    }
}

}  // namespace

void report_waves(const Options& options) {
    fmt::print(R"(
## Waves over a flat floor

Waves of 0.5 m in water of n = 4/3, as many periods as make {2} pixels a side at least, {3} cells of the surface along each
pixel. One sample a pixel: one landed ray, quad, vertex or cell of beams, and {0} x {0} photons, of which `blurred` means a
Gaussian of {1:g} pixel. RMSE of pixel averages relative to that of the truth; `order` by least squares of its logarithm
against that of the pixels. Photons of one number a pixel are as noisy at every resolution: how they converge is in a table
of their own. `light - 1` is the light on the map over that which the truth lets through the surface, less one, the worst of
the resolutions.
)",
               photons_along_pixel, photon_blur, least_pixels, cells_along_pixel);
    for (const double depth : {1.0, 3.0, 8.0}) report_scene(options, accuracy::egg_crate(), depth);
    for (const double depth : {1.0, 3.0}) report_scene(options, accuracy::crossed_waves(), depth);
    report_scene(options, accuracy::skew_wave(), 2);
    report_photon_numbers(options);
}

}  // namespace waterlight::methods
