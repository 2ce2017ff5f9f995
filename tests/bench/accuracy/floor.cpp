// The floor map against the truth, over resolution, depth and steepness.
#include <fmt/format.h>

#include "caustics/floor_vulkan.hpp"
#include "tests/bench/accuracy/report.hpp"
#include "tests/bench/accuracy/scenes.hpp"

namespace waterlight::accuracy {

namespace {

struct Method {
    std::string name;
    Footprint footprint;
    int samples;
};

const std::vector<Method> methods{
    {"pixel", Footprint::pixel, 1}, {"adaptive", Footprint::adaptive, 1}, {"adaptive, 2 x 2", Footprint::adaptive, 2}};

/// A scene at one depth.
struct Place {
    Scene scene;
    double depth_m;
    std::string depth;  ///< in words
    std::string where() const { return fmt::format("{}, {}", scene.name, depth); }
};

/// One method at one resolution: relative RMSE of pixel averages, in boxes of 4 x 4 pixels, and in boxes of a
/// sixteenth of the period; light on the map over that of the truth; time on each back-end.
struct Errors {
    double pixel = 0, boxes = 0, sixteenth = 0, energy = 1;
};

struct Row {
    int p = 0;
    FloorWindow window;
    std::vector<Errors> errors;  ///< by method
    std::vector<Timed> cpu;
    std::vector<Timed> vulkan;  ///< the CPU's first once more, then Vulkan's; empty without a device
};

Errors errors_of(const Scene& scene, const FloorMap& map, const Field<double>& truth) {
    const auto in_boxes = [&](int bx, int by) {
        if (scene.aspect == 0) by = 1;
        return relative_rms(box_means(map.irradiance, bx, by), box_means(truth, bx, by));
    };
    const int sixteenth = truth.nx() / 16;
    double found = 0, exact = 0;
    for (int j = 0; j < truth.ny(); ++j)
        for (int i = 0; i < truth.nx(); ++i) found += map.irradiance(i, j), exact += truth(i, j);
    return {in_boxes(1, 1), in_boxes(4, 4), in_boxes(sixteenth, sixteenth * std::max(1, scene.aspect / 2)),
            found / exact};
}

/// Maps of all methods over the same periods, each with a surface of as many cells as samples.
class Maps {
  public:
    Maps(const Options& options, const Place& place, int p) : grid_(many_periods(place.scene, p, map_side(options))) {
        for (const Method& m : methods) add(place, m, make_floor_cpu(settings(place, m)));
        if (!options.context) return;
        for (const Method& m : methods) add(place, m, make_floor_vulkan(settings(place, m), options.context));
    }

    Row measure(const Place& place, int p, const Field<double>& truth, double budget_s) {
        std::vector<std::function<void()>> cpu, vulkan;
        for (std::size_t k = 0; k < jobs_.size(); ++k) {
            Job& job = jobs_[k];
            const auto work = [&job] { job.mapper->compute(job.surface, job.map); };
            if (k < methods.size()) cpu.emplace_back(work);
            if (k == 0 || k >= methods.size()) vulkan.emplace_back(work);
        }
        Row row{p, {}, {}, time_together(cpu, budget_s), {}};
        if (vulkan.size() > 1) row.vulkan = time_together(vulkan, budget_s);
        row.window = jobs_.front().map.window;
        for (std::size_t k = 0; k < methods.size(); ++k)
            row.errors.push_back(errors_of(place.scene, jobs_[k].map, truth));
        return row;
    }
    const Grid& grid() const { return grid_; }

  private:
    struct Job {
        Surface surface;
        std::unique_ptr<FloorMapper> mapper;
        FloorMap map;
    };

    FloorSettings settings(const Place& place, const Method& m) const {
        FloorSettings s;
        s.plan = cover(grid_, grid_.nx, grid_.ny);
        s.footprint = m.footprint;
        s.samples_per_pixel = m.samples;
        s.depth_m = place.depth_m;
        s.sun = place.scene.sun;
        return s;
    }
    void add(const Place& place, const Method& m, std::unique_ptr<FloorMapper> mapper) {
        const Grid cells = make_grid(m.samples * grid_.nx, m.samples * grid_.ny, grid_.width_m(), grid_.height_m());
        jobs_.push_back({test::sample(cells, periodic, place.scene.waves), std::move(mapper), {}});
    }

    Grid grid_;
    std::vector<Job> jobs_;
};

/// Microseconds for a square of one wavelength each way.
double us_a_square_wave(double ms, const Grid& grid) {
    return 1e3 * ms * wave_m * wave_m / (grid.width_m() * grid.height_m());
}

std::vector<Row> measure(const Options& options, const Place& place, const std::vector<int>& resolutions,
                         const TruthMap& fine, Choices& choices) {
    std::vector<Row> rows;
    for (const int p : resolutions) {
        Maps maps(options, place, p);
        rows.push_back(maps.measure(place, p, truth_at_pixels(place.scene, fine, p), options.quick ? .03 : .25));
        const Row& row = rows.back();
        for (std::size_t m = 0; m < methods.size(); ++m) {
            const auto add = [&](const char* backend, const Timed& t) {
                choices.add(place.where(), {fmt::format("{}, {}, {}", methods[m].name, p, backend),
                                            row.errors[m].sixteenth, us_a_square_wave(t.ms, maps.grid())});
            };
            add("cpu", row.cpu[m]);
            if (!row.vulkan.empty()) add("vulkan", row.vulkan[m + 1]);
        }
    }
    return rows;
}

/// An error that the truth's own may have a part in is marked.
std::string judged(double error, double truth_estimate) {
    return fmt::format("{}{}", truth_estimate > error / 3 ? "~" : "", percent(error));
}

std::vector<std::string> error_cells(std::vector<std::string> first, const Row& row, double estimate) {
    for (const Errors& e : row.errors) first.push_back(judged(e.pixel, estimate));
    for (const Errors& e : row.errors) first.push_back(judged(e.boxes, estimate));
    for (const Errors& e : row.errors) first.push_back(fmt::format("{:+.0e}", e.energy - 1));
    first.push_back(percent(estimate));
    return first;
}

void print_errors(const Place& place, const std::vector<Row>& rows, double estimate) {
    for (const Row& row : rows) print_row(error_cells({place.depth, std::to_string(row.p)}, row, estimate));
    std::vector<int> resolutions;
    for (const Row& row : rows) resolutions.push_back(row.p);
    std::vector<std::string> cells{place.depth, "order"};
    for (const auto error : {&Errors::pixel, &Errors::boxes}) {
        for (std::size_t m = 0; m < methods.size(); ++m) {
            std::vector<double> errors;
            for (const Row& row : rows) errors.push_back(row.errors[m].*error);
            cells.push_back(fmt::format("{:.2f}", order_of(resolutions, errors)));
        }
    }
    cells.resize(cells.size() + methods.size() + 1);
    print_row(cells);
}

std::vector<std::string> error_heads(const std::string& first, const std::string& second) {
    std::vector<std::string> heads{first, second};
    for (const char* in : {"", " in 4 x 4", " energy - 1"})
        for (const Method& m : methods) heads.push_back(m.name + in);
    heads.emplace_back("truth's estimate");
    return heads;
}

void print_times(const Place& place, const std::vector<Row>& rows) {
    for (const Row& row : rows) {
        std::vector<std::string> cells{place.depth, std::to_string(row.p),
                                       fmt::format("{} x {}", row.window.samples, row.window.channels),
                                       fmt::format("{:.2f}", row.cpu[0].ms)};
        for (std::size_t m = 1; m < methods.size(); ++m) cells.push_back(fmt::format("{:.1f}", row.cpu[m].ratio));
        for (std::size_t k = 1; k < row.vulkan.size(); ++k) cells.push_back(fmt::format("{:.3g}", row.vulkan[k].ratio));
        print_row(cells);
    }
}

std::vector<std::string> time_heads(const Options& options) {
    std::vector<std::string> heads{"depth", "pixels", "window", "pixel cpu, ms", "adaptive cpu", "adaptive, 2 x 2 cpu"};
    if (options.context)
        for (const Method& m : methods) heads.push_back(m.name + " vulkan");
    return heads;
}

std::string description(const Scene& scene, double focus_m) {
    return fmt::format("\n### {}\n\nPeriod {:.3g} x {:.3g} m, sun at {:g} degrees, first focus at {:.3f} m.\n",
                       scene.name, scene.period_m.x, scene.period_m.y, scene.sun.elevation_deg, focus_m);
}

/// The truth as a method: what fewer samples give.
void measure_truth(const Place& place, const TruthMap& fine, Choices& choices) {
    const int p = std::min(64, place.scene.finest / 2), ny = place.scene.aspect > 0 ? place.scene.aspect * p : p;
    const bool lines = place.scene.aspect == 0;
    const Grid grid = make_grid(p, ny, place.scene.period_m.x, lines ? place.scene.period_m.x : place.scene.period_m.y);
    const Surface surface = test::sample(grid, periodic, place.scene.waves);
    TruthSettings t;
    t.floor.plan = cover(grid, grid.nx, grid.ny);
    t.floor.depth_m = place.depth_m;
    t.floor.sun = place.scene.sun;
    t.floor.footprint = Footprint::pixel;
    const auto mapper = make_floor_cpu(t.floor);
    for (const int samples : {1, 2, 4}) {
        t.subsamples = samples;
        t.most_subsamples = 2 * samples;
        t.tolerance = 1e-12;
        TruthMap truth;
        FloorMap map;
        const auto times =
            time_together({[&] { mapper->compute(surface, map); },
                           [&] { truth = truth_map(t, test::as_truth(grid, periodic, place.scene.waves)); }},
                          .1);
        const Field<double> exact = truth_at_pixels(place.scene, fine, p);
        const auto in_boxes = [&](int bx, int by) {
            return relative_rms(box_means(truth.irradiance, bx, lines ? 1 : by), box_means(exact, bx, lines ? 1 : by));
        };
        const double error = in_boxes(1, 1), sixteenth = in_boxes(p / 16, p / 16 * std::max(1, place.scene.aspect / 2));
        choices.add(place.where(), {fmt::format("truth, {}, {} samples", p, truth.subsamples), sixteenth,
                                    us_a_square_wave(times[1].ms, grid)});
        print_row({place.scene.name, place.depth, std::to_string(truth.subsamples), judged(error, fine.error_estimate),
                   percent(truth.error_estimate), fmt::format("{:.3g}", times[1].ratio)});
    }
}

/// A scene's rows at each depth, and the truth that they were measured against.
struct Depth {
    Place place;
    TruthMap fine;
    std::vector<Row> rows;
};

void report_scene(const Options& options, const Scene& scene, std::vector<Depth>& all, Choices& choices) {
    const double focus = first_focus_m(scene);
    fmt::print("{}", description(scene, focus));
    std::vector<int> resolutions;
    for (int p = 16; p <= (options.quick ? 32 : scene.finest); p *= 2) resolutions.push_back(p);
    print_heads(error_heads("depth", "pixels"));
    const std::size_t first = all.size();
    for (const auto& [factor, words] : {std::pair{.5, "half the focus"}, {1.0, "at it"}, {2.0, "twice"}}) {
        if (options.quick && factor == 1) continue;
        all.push_back({{scene, factor * focus, words}, {}, {}});
        Depth& depth = all.back();
        depth.fine = fine_truth(scene, depth.place.depth_m);
        depth.rows = measure(options, depth.place, resolutions, depth.fine, choices);
        print_errors(depth.place, depth.rows, depth.fine.error_estimate);
    }
    fmt::print("\nTimes of those maps, all but the first as multiples of the first:\n");
    print_heads(time_heads(options));
    for (std::size_t k = first; k < all.size(); ++k) print_times(all[k].place, all[k].rows);
}

void report_steepness(const Options& options) {
    fmt::print(
        "\n### Steepness\n\nThe sine of other heights, 128 pixels a wave, each at depths by its own first focus:\n");
    print_heads(error_heads("ka", "depth, m"));
    const double k = 2 * std::numbers::pi / wave_m;
    for (const double ka : {.02, .05, .1, .2, .3}) {
        if (options.quick && ka != .3) continue;
        const Scene scene = frozen_sine(ka / k);
        const double focus = first_focus_m(scene);
        for (const double factor : {.5, 2.0}) {
            const Place place{scene, factor * focus, fmt::format("{:.3g}", factor * focus)};
            const TruthMap fine = fine_truth(scene, place.depth_m);
            Choices unused;
            const std::vector<Row> rows = measure({options.quick, nullptr}, place, {128}, fine, unused);
            print_row(error_cells({fmt::format("{:g}", ka), place.depth}, rows[0], fine.error_estimate));
        }
    }
}

}  // namespace

void report_floor(const Options& options, Choices& choices) {
    fmt::print(R"(
## The floor map

Waves of {1} m in water of n = 4/3. `pixels` are those of a period along x; a surface has as many cells as the map has
samples. Errors are relative RMSE of pixel averages, then of averages over 4 x 4 pixels, then the light on the map over that
of the truth, less one. `~` marks an error of which the truth's own may be more than a third. Times are of maps of
{0} x {0} pixels and somewhat more.
)",
               map_side(options), wave_m);
    std::vector<Scene> scenes{frozen_sine(.01), egg_crate(), crossed_waves(), skew_wave()};
    if (options.quick) {
        scenes = {frozen_sine(.01), crossed_waves()};
        for (Scene& scene : scenes) scene.finest = 64;
    }
    std::vector<Depth> all;
    for (const Scene& scene : scenes) report_scene(options, scene, all, choices);
    report_steepness(options);
    fmt::print(
        "\n### The truth itself\n\nOf few samples a pixel and axis, 64 pixels a period, against the truth of the "
        "tables above; "
        "its time as a multiple of\nthat of `pixel` of the same map:\n");
    print_heads({"scene", "depth", "samples", "error", "its own estimate", "times pixel"});
    for (const Depth& depth : all) measure_truth(depth.place, depth.fine, choices);
}

}  // namespace waterlight::accuracy
