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
    std::vector<Errors> vulkan_errors;
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

/// Maps over the same periods, each with a surface of as many cells as samples.
class Maps {
  public:
    Maps(const Place& place, int p, int side) : place_(place), grid_(many_periods(place.scene, p, side)) {}

    void add(const Method& m, const std::function<std::unique_ptr<FloorMapper>(const FloorSettings&)>& make) {
        FloorSettings s;
        s.plan = cover(grid_, grid_.nx, grid_.ny);
        s.footprint = m.footprint;
        s.samples_per_pixel = m.samples;
        s.depth_m = place_.depth_m;
        s.sun = place_.scene.sun;
        const Grid cells = make_grid(m.samples * grid_.nx, m.samples * grid_.ny, grid_.width_m(), grid_.height_m());
        jobs_.push_back({test::sample(cells, periodic, place_.scene.waves), make(s), {}});
    }
    std::vector<Timed> time(const Options& options, double budget_s) {
        std::vector<std::function<void()>> works;
        for (Job& job : jobs_) works.emplace_back([&job] { job.mapper->compute(job.surface, job.map); });
        return time_together(options, works, budget_s);
    }
    const FloorMap& map(std::size_t k) const { return jobs_[k].map; }
    const Grid& grid() const { return grid_; }

  private:
    struct Job {
        Surface surface;
        std::unique_ptr<FloorMapper> mapper;
        FloorMap map;
    };
    const Place& place_;
    Grid grid_;
    std::vector<Job> jobs_;
};

/// The yardstick's pixels for a square of one wavelength each way.
double for_a_square_wave(const Timed& time, const Grid& grid) {
    return time.pixels * wave_m * wave_m / (grid.width_m() * grid.height_m());
}

/// A program that plays a GPU takes seconds for a map of a wide window.
bool plays_a_gpu(const gpu::Context& context) { return context.device().type == gpu::DeviceType::cpu; }
constexpr int most_pixels_played = 64;

Row measure_one(const Options& options, const Place& place, int p, const Field<double>& truth, Choices& choices) {
    const double budget_s = options.quick ? .03 : .7;
    const auto choose = [&](std::size_t m, const char* backend, const Errors& e, const Timed& t, const Grid& grid) {
        choices.add(place.where(),
                    {fmt::format("{}, {}, {}", methods[m].name, p, backend), e.sixteenth, for_a_square_wave(t, grid)});
    };
    Maps cpu(place, p, map_side(options));
    for (const Method& m : methods) cpu.add(m, make_floor_cpu);
    Row row;
    row.p = p;
    row.cpu = cpu.time(options, budget_s);
    row.window = cpu.map(0).window;
    for (std::size_t m = 0; m < methods.size(); ++m) {
        row.errors.push_back(errors_of(place.scene, cpu.map(m), truth));
        choose(m, "cpu", row.errors[m], row.cpu[m], cpu.grid());
    }
    if (!options.context || (plays_a_gpu(*options.context) && p > most_pixels_played)) return row;
    Maps vulkan(place, p, plays_a_gpu(*options.context) ? map_side(options) / 2 : map_side(options));
    vulkan.add(methods[0], make_floor_cpu);
    for (const Method& m : methods)
        vulkan.add(m, [&](const FloorSettings& s) { return make_floor_vulkan(s, options.context); });
    row.vulkan = vulkan.time(options, budget_s / 2);
    for (std::size_t m = 0; m < methods.size(); ++m) {
        row.vulkan_errors.push_back(errors_of(place.scene, vulkan.map(m + 1), truth));
        choose(m, "vulkan", row.vulkan_errors[m], row.vulkan[m + 1], vulkan.grid());
    }
    return row;
}

std::vector<Row> measure(const Options& options, const Place& place, const std::vector<int>& resolutions,
                         const TruthMap& fine, Choices& choices) {
    std::vector<Row> rows;
    for (const int p : resolutions)
        rows.push_back(measure_one(options, place, p, truth_at_pixels(place.scene, fine, p), choices));
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

std::vector<std::string> time_heads(const Options& options) {
    std::vector<std::string> heads{"depth", "pixels", "window", "pixel cpu, ms", "adaptive cpu", "adaptive, 2 x 2 cpu"};
    if (!options.context) return heads;
    for (const char* what : {" vulkan", " vulkan, RMSE"})
        for (const Method& m : methods) heads.push_back(m.name + what);
    return heads;
}

void print_times(const Options& options, const Place& place, const std::vector<Row>& rows) {
    for (const Row& row : rows) {
        std::vector<std::string> cells{place.depth, std::to_string(row.p),
                                       fmt::format("{} x {}", row.window.samples, row.window.channels),
                                       fmt::format("{:.2f}", row.cpu[0].ms)};
        for (std::size_t m = 1; m < methods.size(); ++m) cells.push_back(fmt::format("{:.1f}", row.cpu[m].ratio));
        for (std::size_t k = 1; k < row.vulkan.size(); ++k) cells.push_back(digits(row.vulkan[k].ratio));
        for (const Errors& e : row.vulkan_errors) cells.push_back(percent(e.pixel));
        cells.resize(time_heads(options).size());
        print_row(cells);
    }
}

std::string description(const Scene& scene, double focus_m) {
    return fmt::format("\n### {}\n\nPeriod {:.3g} x {:.3g} m, sun at {:g} degrees, first focus at {:.3f} m.\n",
                       scene.name, scene.period_m.x, scene.period_m.y, scene.sun.elevation_deg, focus_m);
}

int truth_pixels(const Scene& scene) { return std::min(64, scene.finest / 2); }

/// The truth as a method: what fewer samples give.
void measure_truth(const Options& options, const Place& place, const TruthMap& fine, Choices& choices) {
    const int p = truth_pixels(place.scene), ny = place.scene.aspect > 0 ? place.scene.aspect * p : p;
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
            time_together(options,
                          {[&] { mapper->compute(surface, map); },
                           [&] { truth = truth_map(t, test::as_truth(grid, periodic, place.scene.waves)); }},
                          .3);
        const Field<double> exact = truth_at_pixels(place.scene, fine, p);
        const auto in_boxes = [&](int bx, int by) {
            return relative_rms(box_means(truth.irradiance, bx, lines ? 1 : by), box_means(exact, bx, lines ? 1 : by));
        };
        const double error = in_boxes(1, 1), sixteenth = in_boxes(p / 16, p / 16 * std::max(1, place.scene.aspect / 2));
        choices.add(place.where(), {fmt::format("truth, {}, {} samples", p, truth.subsamples), sixteenth,
                                    for_a_square_wave(times[1], grid)});
        print_row({place.scene.name, place.depth, std::to_string(truth.subsamples), judged(error, fine.error_estimate),
                   percent(truth.error_estimate), digits(times[1].ratio)});
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
    for (int p = 16; p <= (options.quick ? 64 : scene.finest); p *= 2) resolutions.push_back(p);
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
    for (std::size_t k = first; k < all.size(); ++k) print_times(options, all[k].place, all[k].rows);
}

void report_steepness(const Options& options) {
    fmt::print(
        R"(
### Steepness

The sine of other heights, 128 pixels a wave, each at depths by its own first focus:
)");
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
            const std::vector<Row> rows =
                measure({options.quick, nullptr, options.yardstick}, place, {128}, fine, unused);
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
{0} x {0} pixels and somewhat more; on Vulkan, where a program plays the GPU, of half that along each side and up to
{2} pixels a period.
)",
               map_side(options), wave_m, most_pixels_played);
    std::vector<Scene> scenes{frozen_sine(.01), egg_crate(), crossed_waves(), skew_wave()};
    if (options.quick) {
        scenes = {frozen_sine(.01), crossed_waves()};
        for (Scene& scene : scenes) scene.finest = 64;
    }
    std::vector<Depth> all;
    for (const Scene& scene : scenes) report_scene(options, scene, all, choices);
    report_steepness(options);
    fmt::print(
        R"(
### The truth itself

Of few samples a pixel and axis, {} pixels a period, against the truth of the tables above; its time as a multiple of that
of `pixel` of the same map:
)",
        truth_pixels(all.front().place.scene));
    print_heads({"scene", "depth", "samples", "error", "its own estimate", "times pixel"});
    for (const Depth& depth : all) measure_truth(options, depth.place, depth.fine, choices);
}

}  // namespace waterlight::accuracy
