// Drops on a pool: error against time and memory, and who wins at equal error.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "caustics/truth.hpp"
#include "scenarios/build.hpp"
#include "scenarios/reader.hpp"
#include "scenarios/resolve.hpp"
#include "scenarios/resolve_light.hpp"
#include "tests/bench/methods/memory.hpp"
#include "tests/bench/methods/methods.hpp"
#include "tests/bench/methods/report.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight::methods {

namespace {

constexpr double moment_s = 6.5;

/// The surface between its cells as the truth has it, so finely that methods, which take it linear there, have the
/// same.
Surface refined(const Surface& coarse) {
    constexpr int finer = 2;
    const Grid& g = coarse.grid;
    const TruthSurface exact = interpolate(coarse);
    return test::sample(make_grid(finer * g.nx, finer * g.ny, g.width_m(), g.height_m()), coarse.boundary, exact.at);
}

/// The pool of scenarios/pool.toml at one moment.
struct Pool {
    Scenario scenario;
    BuiltModel model;
    Surface surface;

    explicit Pool(const Options& options)
        : scenario(read_scenario(options.scenarios + "/pool.toml")), model(build_model(scenario)) {
        model.model->advance(moment_s);
        surface = refined(model.model->surface());
    }
    TruthSurface exact() { return interpolate(model.model->surface()); }
    FloorSettings settings(int width) const {
        FloorSettings s = floor_settings(scenario);
        s.plan = cover(surface.grid, width, width * 3 / 4);
        return s;
    }
};

TruthMap truth_of(Pool& pool, int width) {
    TruthSettings t;
    t.floor = pool.settings(width);
    t.subsamples = 4;
    t.most_subsamples = 8;
    return truth_map(t, pool.exact());
}

/// One method with so many samples.
struct Run {
    std::string method;
    int finer = 1;
    double ms = 0, mebibytes = 0, rmse = 0, in_boxes = 0, light = 0;
};

/// Samples along a pixel that are tried; of photons not more than a map of 2048 squared.
std::vector<int> samples_of(const Options& options, const Method& method, int width) {
    constexpr int most_photons = 2048;
    std::vector<int> all{1, 2};
    if (!options.common.quick && width <= 256) all.push_back(4);
    if (method.name.starts_with("photons"))
        std::erase_if(all, [&](int finer) { return photons_along_pixel * finer * width > most_photons; });
    return all;
}

std::vector<Run> runs_of(const Options& options, const Pool& pool, int width, const TruthMap& fine) {
    const int box = fine.irradiance.nx() / width;
    const Field<double> truth = accuracy::box_means(fine.irradiance, box, box);
    const double through = fine.ledger.incident_w - fine.ledger.reflected_w - fine.ledger.outside_w;
    const FloorSettings settings = pool.settings(width);
    std::vector<Run> runs;
    std::vector<FloorMap> maps;
    std::vector<std::function<void()>> works;
    for (const Method& method : all_methods())
        for (const int finer : samples_of(options, method, width)) runs.push_back({method.name, finer});
    maps.resize(runs.size());
    std::size_t k = 0;
    for (const Method& method : all_methods())
        for (const int finer : samples_of(options, method, width)) {
            Mapper mapper;
            runs[k].mebibytes = static_cast<double>(peak_bytes([&] {
                                    mapper = method.make(settings, finer);
                                    mapper(pool.surface, maps[k]);
                                })) /
                                (1 << 20);
            works.emplace_back([mapper, &map = maps[k], &pool] { mapper(pool.surface, map); });
            ++k;
        }
    const std::vector<accuracy::Timed> times = accuracy::time_together(options.common, works, 0);
    for (k = 0; k < runs.size(); ++k) {
        const Field<double> found = accuracy::box_means(maps[k].irradiance, 1, 1);
        runs[k].ms = times[k].ms;
        runs[k].rmse = accuracy::relative_rms(found, truth);
        runs[k].in_boxes = accuracy::relative_rms(accuracy::box_means(found, 4, 4), accuracy::box_means(truth, 4, 4));
        double sum = 0;
        for (const double e : found.values()) sum += e;
        runs[k].light = sum * settings.plan.pitch_m.x * settings.plan.pitch_m.y / through - 1;
    }
    return runs;
}

void print_runs(const std::vector<Run>& runs) {
    accuracy::print_heads({"method", "samples a pixel", "ms", "MiB", "RMSE", "RMSE in 4 x 4", "light - 1"});
    for (const Run& r : runs) {
        const int along = r.method.starts_with("photons") ? photons_along_pixel * r.finer : r.finer;
        accuracy::print_row({r.method, std::to_string(along * along), accuracy::digits(r.ms),
                             accuracy::digits(r.mebibytes), accuracy::percent(r.rmse), accuracy::percent(r.in_boxes),
                             fmt::format("{:+.1e}", r.light)});
    }
}

/// Time at which a method's error is the target: along straight lines between its runs where both are logarithms.
std::optional<double> ms_at(const std::vector<Run>& runs, const std::string& method, double Run::*error,
                            double target) {
    std::optional<double> least;
    const Run* before = nullptr;
    for (const Run& r : runs) {
        if (r.method != method) continue;
        std::optional<double> ms;
        if (r.*error <= target) ms = r.ms;
        if (before != nullptr && before->*error > target && r.*error <= target) {
            const double part = std::log(before->*error / target) / std::log(before->*error / r.*error);
            ms = before->ms * std::pow(r.ms / before->ms, part);
        }
        if (ms && (!least || *ms < *least)) least = ms;
        before = &r;
    }
    return least;
}

/// Who is fastest at each error, and how many times as long the others take.
void print_winners(const std::vector<Run>& runs, double Run::*error, const std::vector<double>& targets) {
    std::vector<std::string> heads{"RMSE", "fastest", "ms"};
    for (const Method& m : all_methods()) heads.push_back(m.name);
    accuracy::print_heads(heads);
    for (const double target : targets) {
        std::string winner = "none";
        std::optional<double> least;
        for (const Method& m : all_methods()) {
            const std::optional<double> ms = ms_at(runs, m.name, error, target);
            if (ms && (!least || *ms < *least)) {
                least = ms;
                winner = m.name;
            }
        }
        std::vector<std::string> cells{accuracy::percent(target), winner, least ? accuracy::digits(*least) : ""};
        for (const Method& m : all_methods()) {
            const std::optional<double> ms = ms_at(runs, m.name, error, target);
            cells.push_back(ms ? fmt::format("{:.3g}", *ms / *least) : "not reached");
        }
        accuracy::print_row(cells);
    }
}

/// The same in words.
void say_winner(const std::vector<Run>& runs, double target) {
    std::vector<std::pair<double, std::string>> order;
    std::string none;
    for (const Method& m : all_methods()) {
        if (const std::optional<double> ms = ms_at(runs, m.name, &Run::rmse, target))
            order.emplace_back(*ms, m.name);
        else
            none += (none.empty() ? "" : "; ") + m.name;
    }
    std::ranges::sort(order);
    if (order.empty()) return;
    fmt::print("\n**At an error of {} {} wins**", accuracy::percent(target), order.front().second);
    for (std::size_t k = 1; k < order.size(); ++k)
        fmt::print("{} {} takes {} times as long", k == 1 ? ":" : ",", order[k].second,
                   accuracy::digits(order[k].first / order.front().first));
    fmt::print(".{}\n", none.empty() ? "" : " None of these reached it: " + none + ".");
}

/// Error against time, all methods of one map.
void plot(const Options& options, const std::vector<Run>& runs, int width) {
    if (options.pictures.empty()) return;
    FILE* out = popen("gnuplot", "w");
    if (out == nullptr) return;
    fmt::print(out, "set terminal pngcairo size 900,600 font 'sans,11'\nset output '{}/pool.png'\n", options.pictures);
    fmt::print(out,
               "set logscale xy\nset grid\nset key outside right\nset xlabel 'ms'\nset ylabel 'relative RMSE of pixel "
               "averages'\nset title 'A pool, {} x {} pixels'\nplot ",
               width, width * 3 / 4);
    const std::vector<Method> all = all_methods();
    for (std::size_t m = 0; m < all.size(); ++m)
        fmt::print(out, "{}'-' with linespoints linewidth 2 pointtype {} title '{}'", m > 0 ? ", " : "", m + 4,
                   all[m].name);
    fmt::print(out, "\n");
    for (const Method& m : all) {
        for (const Run& r : runs)
            if (r.method == m.name) fmt::print(out, "{} {}\n", r.ms, r.rmse);
        fmt::print(out, "e\n");
    }
    pclose(out);
}

}  // namespace

void report_pool(const Options& options) {
    Pool pool(options);
    const int finest = options.common.quick ? 128 : 512;
    const TruthMap fine = truth_of(pool, finest);
    fmt::print(R"(
## A pool

`scenarios/pool.toml` after {} s: 8 x 6 m, 2 m deep, waves of drops on 512 x 384 cells, walls, the sun at 60 degrees. The
truth is of {} x {} pixels, averaged where a map is coarser; its own estimate of its error is {}. It takes the surface
bicubic between cells; the methods have the same on 1024 x 768, and there take it bilinear: errors of a few per mille at the
finest are of that. `MiB` is the most that a method allocates at once, its map and first call included, less what Embree and
stacks take. `light - 1` as above.
)",
               moment_s, finest, finest * 3 / 4, accuracy::percent(fine.error_estimate));
    for (int width = finest / 4; width <= finest; width *= 2) {
        const std::vector<Run> runs = runs_of(options, pool, width, fine);
        fmt::print("\n### {} x {} pixels\n", width, width * 3 / 4);
        print_runs(runs);
        fmt::print("\nTime at equal error, of pixel averages, as multiples of the fastest:\n");
        print_winners(runs, &Run::rmse, {.1, .05, .02, .01, .005});
        say_winner(runs, width < finest ? 0.02 : 0.01);
        fmt::print("\nAnd of averages over 4 x 4 pixels:\n");
        print_winners(runs, &Run::in_boxes, {.05, .02, .01, .005, .002});
        if (width == finest / 2) plot(options, runs, width);
        if (width == finest / 2 && !options.pictures.empty())
            fmt::print("\n![Error against time, every method](methods/pool.png)\n");
    }
}

}  // namespace waterlight::methods
