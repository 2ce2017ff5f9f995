// How fast the shallow-water model converges to exact states, as Markdown:
//   waterlight_convergence [float|double] [thacker|vortex|cost|ritter|stoker|bump|oblique]...
// Without a precision both, without a case all. Errors are relative L1 of depth against means over the cells of the
// exact state. The reference is what Basilisk's second-order scheme (MUSCL, double) reaches on the same grid.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "sim/shallow_initial.hpp"
#include "sim/shallow_means.hpp"
#include "tests/bench/seconds_of.hpp"

namespace {

using namespace waterlight;

constexpr double pi = std::numbers::pi;
using Maker = std::function<std::unique_ptr<ShallowWaterModel>(const ShallowWaterSettings&)>;

struct Precision {
    std::string name;
    Maker make;
    double steady;  ///< relative change per second below which a run counts as steady
};

void print_row(const std::vector<std::string>& cells) {
    for (const std::string& cell : cells) fmt::print("| {} ", cell);
    fmt::print("|\n");
    std::fflush(stdout);
}

void print_heads(const std::vector<std::string>& heads) {
    print_row(heads);
    print_row(std::vector<std::string>(heads.size(), "---:"));
}

void title(const std::string& what, const Precision& precision) {
    fmt::print("\n### {}, {}\n\n", what, precision.name);
}

std::string cells_of(const Grid& grid) { return fmt::format("{} x {}", grid.nx, grid.ny); }

/// Errors on finer and finer grids; the order from each to the next.
class Orders {
  public:
    std::string next(int cells, double error) {
        const std::string text =
            cells_ > 0 ? fmt::format("{:.2f}", std::log(error_ / error) / std::log(double(cells) / cells_)) : "";
        cells_ = cells;
        error_ = error;
        return text;
    }

  private:
    int cells_ = 0;
    double error_ = 0;
};

/// A run from `state` over its own ground, not begun yet.
ShallowWaterSettings settings_of(const ShallowExact& state, const Grid& grid, const ShallowSides& sides) {
    ShallowWaterSettings settings;
    settings.grid = grid;
    settings.sides = sides;
    settings.bed_m = bed_at_centres(state, grid);
    return settings;
}

double relative_l1(const ShallowWaterModel& model, const Grid& grid, const Field<double>& exact) {
    double error = 0, sum = 0;
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            error += std::abs(model.state(i, j).depth_m - exact(i, j));
            sum += exact(i, j);
        }
    }
    return error / sum;
}

struct Ended {
    std::unique_ptr<ShallowWaterModel> model;
    double error;
    double seconds;
};

/// From the exact state at start_s to end_s.
Ended run(const Precision& precision, const ShallowExact& state, const Grid& grid, const ShallowSides& sides,
          std::pair<double, double> start_end_s) {
    const double start_s = start_end_s.first, end_s = start_end_s.second;
    ShallowWaterSettings settings = settings_of(state, grid, sides);
    set_initial({ExactStart{state, start_s}}, settings);
    Ended ended{precision.make(settings), 0, 0};
    ended.seconds = seconds_of([&] { ended.model->advance(end_s - start_s); });
    ended.error = relative_l1(*ended.model, grid, cell_means(state, grid, end_s).depth_m);
    return ended;
}

/// A grid and the error to beat on it.
struct Level {
    Grid grid;
    double reference;
};

void transient(const Precision& precision, const ShallowExact& state, const ShallowSides& sides,
               std::pair<double, double> start_end_s, const std::vector<Level>& levels) {
    print_heads({"cells", "L1 of depth", "order", "to beat", "seconds"});
    Orders orders;
    for (const auto& [grid, reference] : levels) {
        const Ended ended = run(precision, state, grid, sides, start_end_s);
        print_row({cells_of(grid), fmt::format("{:.2e}", ended.error), orders.next(grid.nx, ended.error),
                   fmt::format("{:.2e}", reference), fmt::format("{:.2f}", ended.seconds)});
    }
}

const ShallowSides walls{};
const ShallowSides periodic{PeriodicSide{}, PeriodicSide{}, PeriodicSide{}, PeriodicSide{}};

void thacker(const Precision& precision) {
    title("Thacker's plane surface in a bowl, after 3 periods", precision);
    const ThackerPlanar state;
    const auto grid = [](int n) { return make_grid(n, n, 4, 4); };
    transient(precision, state, walls, {0, 3 * state.period_s()},
              {{grid(64), 4.9e-2}, {grid(128), 1.29e-2}, {grid(256), 4.0e-3}});
}

void vortex(const Precision& precision) {
    title("Travelling vortex, at 2 s", precision);
    const auto grid = [](int n) { return Grid{n, n, 12.0 / n, 12.0 / n, -6, -6}; };
    transient(precision, TravellingVortex{}, periodic, {0, 2},
              {{grid(64), 2.2e-5}, {grid(128), 3.2e-6}, {grid(256), 5.6e-7}});
}

/// What accuracy costs: the error as a part of the vortex' own dip, since the depth around it is not in question.
void vortex_cost(const Precision& precision) {
    title("Travelling vortex, at 2 s: seconds to reach 1 % and 0.1 % of its dip, L1", precision);
    const TravellingVortex state;
    print_heads({"cells", "L1 over that of the dip", "seconds"});
    std::vector<std::pair<double, double>> costs;  // error, seconds
    for (const int n : {64, 96, 128, 192, 256, 384, 512}) {
        const Grid grid{n, n, 12.0 / n, 12.0 / n, -6, -6};
        const Field<double> exact = cell_means(state, grid, 2).depth_m;
        double dip = 0, sum = 0;
        for (const double h : exact.values()) dip += state.h0_m - h, sum += h;
        const Ended ended = run(precision, state, grid, periodic, {0, 2});
        costs.emplace_back(ended.error * sum / dip, ended.seconds);
        print_row({cells_of(grid), fmt::format("{:.2e}", costs.back().first), fmt::format("{:.3f}", ended.seconds)});
    }
    for (const double wanted : {0.01, 0.001}) {
        for (std::size_t k = 1; k < costs.size(); ++k) {
            const auto [error, seconds] = costs[k];
            const auto [before, before_s] = costs[k - 1];
            if (!(before > wanted && error <= wanted)) continue;
            const double part = std::log(wanted / before) / std::log(error / before);
            fmt::print("\n{:g} % is reached in {:.2g} s, between rows {} and {}.\n", 100 * wanted,
                       before_s * std::pow(seconds / before_s, part), k, k + 1);
        }
    }
}

Grid flume(int n, double length_m) { return {n, 1, length_m / n, length_m / n, 0, 0}; }

void dam_on_dry_ground(const Precision& precision) {
    title("Ritter's dam break, from 1 s to 6 s", precision);
    transient(precision, ritter(), walls, {1, 6}, {{flume(401, 10), 4.3e-4}, {flume(1601, 10), 4.2e-5}});
}

/// Means over the middle half of the state between the two waves.
ShallowState middle_of(const ShallowWaterModel& model, const Grid& grid, const RiemannProblem& dam, double t) {
    const auto middle = dam.middle();
    const double near = dam.at_m.x + t * (middle.velocity_m_s - std::sqrt(dam.gravity_m_s2 * middle.depth_m));
    const double far = dam.at_m.x + t * middle.right_shock_m_s;
    ShallowState mean;
    int count = 0;
    for (int i = 0; i < grid.nx; ++i) {
        if (grid.x_m(i) < 0.75 * near + 0.25 * far || grid.x_m(i) > 0.25 * near + 0.75 * far) continue;
        mean.depth_m += model.state(i, 0).depth_m;
        mean.velocity_m_s += model.state(i, 0).velocity_m_s;
        ++count;
    }
    return {mean.depth_m / count, mean.velocity_m_s / double(count)};
}

void dam_on_wet_ground(const Precision& precision) {
    title("Stoker's dam break, from the still dam to 6 s (middle state: within 0.5 %)", precision);
    const RiemannProblem dam = stoker();
    const auto exact = dam.middle();
    print_heads({"cells", "L1 of depth", "order", "middle depth", "middle velocity", "seconds"});
    Orders orders;
    for (const int n : {400, 800, 1600}) {
        const Grid grid = flume(n, 10);
        const Ended ended = run(precision, dam, grid, walls, {0, 6});
        const ShallowState middle = middle_of(*ended.model, grid, dam, 6);
        print_row({cells_of(grid), fmt::format("{:.2e}", ended.error), orders.next(n, ended.error),
                   fmt::format("{:+.3f} %", 100 * (middle.depth_m / exact.depth_m - 1)),
                   fmt::format("{:+.3f} %", 100 * (middle.velocity_m_s.x / exact.velocity_m_s - 1)),
                   fmt::format("{:.2f}", ended.seconds)});
    }
}

Field<double> depths_of(const ShallowWaterModel& model, const Grid& grid) {
    Field<double> depth(grid.nx, grid.ny);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) depth(i, j) = model.state(i, j).depth_m;
    return depth;
}

/// How a run became steady: its time, and the relative change of depth per second at its end.
struct Settled {
    double time_s = 0;
    double change_per_s = 0;
};

/// Advances by `frame_s` until the depth changes by less than the precision's limit, or limit_s is over.
Settled settle(ShallowWaterModel& model, const Grid& grid, const Precision& precision, double frame_s, double limit_s) {
    Settled settled;
    Field<double> before = depths_of(model, grid);
    do {
        model.advance(frame_s);
        settled.time_s += frame_s;
        const double change = relative_l1(model, grid, before);
        settled.change_per_s = change / frame_s;
        before = depths_of(model, grid);
    } while (settled.change_per_s > precision.steady && settled.time_s < limit_s);
    return settled;
}

/// The widest departure of the discharge from the bump's, relative, at least `clear_m` from the jump.
double discharge_spread(const ShallowWaterModel& model, const Grid& grid, const SteadyBump& bump, double clear_m) {
    const double jump = bump.flow().jump_m;
    double widest = 0;
    for (int i = 0; i < grid.nx; ++i) {
        if (std::abs(grid.x_m(i) - jump) < clear_m) continue;
        const ShallowState s = model.state(i, 0);
        widest = std::max(widest, std::abs(s.depth_m * s.velocity_m_s.x / bump.discharge_m2_s - 1));
    }
    return widest;
}

void one_bump(const Precision& precision, const std::string& regime, const SteadyBump& bump) {
    title("Steady flow over a bump, " + regime, precision);
    print_heads({"cells", "L1 of depth", "order", "discharge, widest departure", "clear of the jump", "run for",
                 "change per s", "seconds"});
    ShallowSides sides;
    sides.west = DischargeSide{constant_series(bump.discharge_m2_s)};
    sides.east = OpenSide{};
    if (bump.flow().regime != BumpRegime::transcritical)
        sides.east = LevelSide{constant_series(bump.downstream_depth_m)};
    Orders orders;
    for (const int n : {100, 200, 400}) {
        const Grid grid = flume(n, 25);
        ShallowWaterSettings settings = settings_of(bump, grid, sides);
        set_initial({StillWater{bump.downstream_depth_m}}, settings);
        const auto model = precision.make(settings);
        Settled settled;
        const double seconds = seconds_of([&] { settled = settle(*model, grid, precision, 10, 600); });
        const double error = relative_l1(*model, grid, cell_means(bump, grid, 0).depth_m);
        print_row({cells_of(grid), fmt::format("{:.2e}", error), orders.next(n, error),
                   fmt::format("{:.1e}", discharge_spread(*model, grid, bump, 0)),
                   fmt::format("{:.1e}", discharge_spread(*model, grid, bump, 3 * grid.dx_m)),
                   fmt::format("{:.0f} s", settled.time_s), fmt::format("{:.0e}", settled.change_per_s),
                   fmt::format("{:.2f}", seconds)});
    }
}

void bumps(const Precision& precision) {
    one_bump(precision, "subcritical", subcritical_bump());
    one_bump(precision, "transcritical", transcritical_bump());
    one_bump(precision, "transcritical with a jump", jump_bump());
}

/// Height at which the depth of column i falls through `level`, going up from the wall; NaN if it does not.
double crossing_m(const ShallowWaterModel& model, const Grid& grid, int i, double level) {
    for (int j = 0; j + 1 < grid.ny; ++j) {
        const double below = model.state(i, j).depth_m, above = model.state(i, j + 1).depth_m;
        if (below >= level && above < level) return grid.y_m(j) + grid.dy_m * (below - level) / (below - above);
    }
    return std::nan("");
}

/// Angle (degrees) between the wall and the line through the jump, by least squares over the middle of the domain.
double jump_from_wall_deg(const ShallowWaterModel& model, const Grid& grid, double level) {
    double n = 0, x_sum = 0, y_sum = 0, xx = 0, xy = 0;
    for (int i = grid.nx / 5; i < grid.nx * 9 / 10; ++i) {
        const double x = grid.x_m(i), y = crossing_m(model, grid, i, level);
        n += 1;
        x_sum += x;
        y_sum += y;
        xx += x * x;
        xy += x * y;
    }
    return std::atan2(n * xy - x_sum * y_sum, n * xx - x_sum * x_sum) * 180 / pi;
}

/// Mean depth along the wall, in the lower half of the water behind the jump.
double depth_at_wall(const ShallowWaterModel& model, const Grid& grid, double from_wall_deg) {
    double sum = 0;
    int count = 0;
    for (int i = grid.nx / 2; i < grid.nx * 9 / 10; ++i) {
        for (int j = 0; grid.y_m(j) < 0.5 * grid.x_m(i) * std::tan(from_wall_deg * pi / 180); ++j) {
            sum += model.state(i, j).depth_m;
            ++count;
        }
    }
    return sum / count;
}

void oblique(const Precision& precision) {
    title("Oblique jump at a wall (angle within 0.3 degrees, depth behind within 1 %)", precision);
    const ObliqueJump jump;
    const auto behind = jump.behind();
    const double turn = jump.deflection_deg * pi / 180;
    const FlowSide inflow{jump.depth_m, jump.speed_m_s * glm::dvec2(std::cos(turn), -std::sin(turn))};
    const ShallowSides sides{inflow, OpenSide{}, WallSide{}, inflow};
    // The inflow everywhere.
    const RiemannProblem start{.left_depth_m = jump.depth_m,
                               .right_depth_m = jump.depth_m,
                               .left_velocity_m_s = jump.speed_m_s,
                               .right_velocity_m_s = jump.speed_m_s,
                               .direction_deg = -jump.deflection_deg};
    print_heads({"cells", "L1 of depth", "order", "angle", "departure", "depth behind", "departure", "run for",
                 "change per s", "seconds"});
    Orders orders;
    for (const int n : {100, 200, 400}) {
        const Grid grid = make_grid(n, n * 3 / 5, 10, 6);
        ShallowWaterSettings settings = settings_of(jump, grid, sides);
        set_initial({ExactStart{start, 0}}, settings);
        const auto model = precision.make(settings);
        Settled settled;
        const double seconds = seconds_of([&] { settled = settle(*model, grid, precision, 1, 10); });
        const double error = relative_l1(*model, grid, cell_means(jump, grid, 0).depth_m);
        const double from_wall = jump_from_wall_deg(*model, grid, 0.5 * (jump.depth_m + behind.depth_m));
        const double angle = from_wall + jump.deflection_deg;
        const double depth = depth_at_wall(*model, grid, from_wall);
        print_row({cells_of(grid), fmt::format("{:.2e}", error), orders.next(n, error), fmt::format("{:.3f}", angle),
                   fmt::format("{:+.3f}", angle - behind.angle_deg), fmt::format("{:.4f} m", depth),
                   fmt::format("{:+.3f} %", 100 * (depth / behind.depth_m - 1)),
                   fmt::format("{:.0f} s", settled.time_s), fmt::format("{:.0e}", settled.change_per_s),
                   fmt::format("{:.2f}", seconds)});
    }
}

const std::vector<std::pair<std::string, void (*)(const Precision&)>> cases{
    {"thacker", thacker},          {"vortex", vortex}, {"cost", vortex_cost}, {"ritter", dam_on_dry_ground},
    {"stoker", dam_on_wet_ground}, {"bump", bumps},    {"oblique", oblique}};
const std::vector<Precision> precisions{{"double", make_shallow_water<double>, 1e-11},
                                        {"float", make_shallow_water<float>, 1e-7}};

bool known(const std::string& word) {
    return std::ranges::any_of(cases, [&](const auto& c) { return c.first == word; }) ||
           std::ranges::any_of(precisions, [&](const auto& p) { return p.name == word; });
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    for (const std::string& word : words) {
        if (known(word)) continue;
        fmt::print(stderr,
                   "{} is not known; say double or float, and thacker, vortex, cost, ritter, stoker, bump or oblique\n",
                   word);
        return 2;
    }
    const auto asked = [&](const std::string& word) { return std::ranges::find(words, word) != words.end(); };
    const bool every_precision = std::ranges::none_of(precisions, [&](const auto& p) { return asked(p.name); });
    const bool every_case = std::ranges::none_of(cases, [&](const auto& c) { return asked(c.first); });
    for (const auto& [name, measure] : cases)
        for (const Precision& precision : precisions)
            if ((every_case || asked(name)) && (every_precision || asked(precision.name))) measure(precision);
    return 0;
}
