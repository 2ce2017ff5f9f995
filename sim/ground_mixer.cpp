#include "sim/ground_mixer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "sim/error.hpp"
#include "sim/text_file.hpp"

namespace waterlight {

namespace {

// Two lengths that differ by less than this part are the same but for rounding.
constexpr double near = 1e-6;

/// What a point adds to a cell, cells being visited in turn.
struct Gift {
    int point = 0;
    AxisShares::Share share;
};

/// Integral up to t of the hat function that is 1 at 0 and 0 at -1 and 1.
double hat_integral(double t) {
    if (t <= -1) return 0;
    if (t >= 1) return 1;
    return t < 0 ? (1 + t) * (1 + t) / 2 : 1 - (1 - t) * (1 - t) / 2;
}

/// Linear between the two points around a place, which is counted in spacings from the first point.
void share_place(double place, int points, int cell, std::vector<Gift>& gifts) {
    const double nearest = std::round(place);
    const double inside = std::clamp(std::abs(place - nearest) < near ? nearest : place, 0.0, points - 1.0);
    const int before = static_cast<int>(inside);
    const double part = inside - before;
    gifts.push_back({before, {cell, 1 - part}});
    if (part > 0) gifts.push_back({before + 1, {cell, part}});
}

/// The mean over [from, to] of what is linear between points and constant beyond them.
void share_interval(double from, double to, int points, int cell, std::vector<Gift>& gifts) {
    const double last = points - 1.0;
    const double a = std::clamp(from, 0.0, last), b = std::clamp(to, 0.0, last);
    const double before = std::min(to, 0.0) - std::min(from, 0.0), after = std::max(to, last) - std::max(from, last);
    const int end = static_cast<int>(std::ceil(b));
    for (int point = static_cast<int>(a); point <= end; ++point) {
        double length = hat_integral(b - point) - hat_integral(a - point);
        if (point == 0) length += before;
        if (point == points - 1) length += after;
        if (length > 0) gifts.push_back({point, {cell, length / (to - from)}});
    }
}

void require_reasonable(const GroundFile& file, const Lattice& lattice) {
    constexpr double farthest_m = 1e12, finest_m = 1e-9;
    const auto bad = [&](double first, double spacing, int count) {
        return !(spacing >= finest_m && std::abs(first) <= farthest_m &&
                 std::abs(first + (count - 1.0) * spacing) <= farthest_m);
    };
    if (!bad(lattice.x0_m, lattice.dx_m, lattice.nx) && !bad(lattice.y0_m, lattice.dy_m, lattice.ny)) return;
    throw InputError(
        fmt::format("{}: its points must lie within 1e12 m of its origin and be 1e-9 m or more apart; "
                    "found the first at ({:g}, {:g}) and spacings {:g}, {:g}",
                    file.path.string(), lattice.x0_m, lattice.y0_m, lattice.dx_m, lattice.dy_m));
}

Lattice checked(const GroundFile& file, const Lattice& lattice) {
    if (!std::isfinite(file.offset_m.x) || !std::isfinite(file.offset_m.y) || !std::isfinite(file.datum_m)) {
        throw InputError(fmt::format("{}: offset_m and datum_m must be finite numbers, found ({}, {}) and {}",
                                     file.path.string(), file.offset_m.x, file.offset_m.y, file.datum_m));
    }
    require_reasonable(file, lattice);
    return lattice;
}

}  // namespace

AxisShares::AxisShares(const Points& points, const Cells& cells) {
    std::vector<Gift> gifts;
    const bool means = points.spacing_m < cells.size_m * (1 - near);
    const auto place_of = [&](double k) {
        return (cells.start_m + k * cells.size_m - points.first_m) / points.spacing_m;
    };
    for (int cell = 0; cell < cells.count; ++cell) {
        const double from = place_of(cell), to = place_of(cell + 1), middle = place_of(cell + 0.5);
        const double first = means ? from : middle, last = means ? to : middle;
        const bool reached = first > -0.5 - near && last < points.count - 0.5 + near;
        if (!reached && !unreached_) unreached_ = cell;
        if (means) {
            share_interval(from, to, points.count, cell, gifts);
        } else {
            share_place(middle, points.count, cell, gifts);
        }
    }
    starts_.assign(static_cast<std::size_t>(points.count) + 1, 0);
    for (const Gift& gift : gifts) ++starts_[static_cast<std::size_t>(gift.point)];
    for (std::size_t p = 0, sum = 0; p < starts_.size(); ++p) starts_[p] = sum += starts_[p];
    shares_.resize(gifts.size());
    // From the ends downwards, which leaves in each place where its point's shares start.
    for (std::size_t k = gifts.size(); k-- > 0;) {
        shares_[--starts_[static_cast<std::size_t>(gifts[k].point)]] = gifts[k].share;
    }
}

GroundMixer::GroundMixer(const GroundFile& file, const Lattice& lattice, const Grid& grid)
    : file_(file),
      lattice_(checked(file, lattice)),
      grid_(grid),
      columns_({lattice.nx, lattice.x0_m + file.offset_m.x, lattice.dx_m}, {grid.nx, grid.x0_m, grid.dx_m}),
      rows_({lattice.ny, lattice.y0_m + file.offset_m.y, lattice.dy_m}, {grid.ny, grid.y0_m, grid.dy_m}),
      sums_(grid.nx, grid.ny),
      weights_(grid.nx, grid.ny) {
    const bool array_of_depths = lower_case(file.path.extension().string()) == ".vti" && file.array == "depth";
    sign_ = file.positive.value_or(array_of_depths ? Positive::down : Positive::up) == Positive::down ? -1 : 1;
    const std::optional<int> i = columns_.unreached_cell(), j = rows_.unreached_cell();
    if (file.outside == OutsideFile::extend || (!i && !j)) return;
    const double left = lattice.x0_m - lattice.dx_m / 2 + file.offset_m.x;
    const double bottom = lattice.y0_m - lattice.dy_m / 2 + file.offset_m.y;
    throw InputError(
        fmt::format("{}: covers [{:g}, {:g}] x [{:g}, {:g}] m, and not the cell at ({:g}, {:g}) m of the "
                    "domain, [{:g}, {:g}] x [{:g}, {:g}] m; outside = \"extend\" would take the nearest "
                    "data there",
                    file.path.string(), left, left + lattice.nx * lattice.dx_m, bottom,
                    bottom + lattice.ny * lattice.dy_m, grid.x_m(i.value_or(0)), grid.y_m(j.value_or(0)), grid.x0_m,
                    grid.x0_m + grid.width_m(), grid.y0_m, grid.y0_m + grid.height_m()));
}

void GroundMixer::add(int column, int row, double number) {
    const double height_m = sign_ * number - file_.datum_m;
    for (const AxisShares::Share* r = rows_.begin(row); r != rows_.end(row); ++r) {
        double* const sums = sums_.row(r->cell);
        double* const weights = weights_.row(r->cell);
        for (const AxisShares::Share* c = columns_.begin(column); c != columns_.end(column); ++c) {
            const double weight = r->weight * c->weight;
            sums[c->cell] += weight * height_m;
            weights[c->cell] += weight;
        }
    }
}

std::string GroundMixer::place(int column, int row) const {
    const double x_m = lattice_.x0_m + column * lattice_.dx_m, y_m = lattice_.y0_m + row * lattice_.dy_m;
    return fmt::format("({:.10g}, {:.10g}) of the file, ({:.10g}, {:.10g}) m of the domain", x_m, y_m,
                       x_m + file_.offset_m.x, y_m + file_.offset_m.y);
}

Field<double> GroundMixer::heights() {
    for (int j = 0; j < grid_.ny; ++j) {
        for (int i = 0; i < grid_.nx; ++i) {
            if (file_.outside == OutsideFile::refuse && weights_(i, j) < 1 - near) {
                throw InputError(
                    fmt::format("{}: lacks points at the cell at ({:g}, {:g}) m of the domain; outside = "
                                "\"extend\" would take the nearest data there",
                                file_.path.string(), grid_.x_m(i), grid_.y_m(j)));
            }
            if (weights_(i, j) > 0) sums_(i, j) /= weights_(i, j);
        }
    }
    if (file_.outside == OutsideFile::extend) extend();
    return std::move(sums_);
}

/// Cells without data are filled from their neighbours, in rounds from those that have data.
void GroundMixer::extend() {
    std::deque<glm::ivec2> filled;
    for (int j = 0; j < grid_.ny; ++j) {
        for (int i = 0; i < grid_.nx; ++i) {
            if (weights_(i, j) > 0) filled.push_back({i, j});
        }
    }
    if (filled.empty()) {
        throw InputError(fmt::format("{}: has no data in the domain", file_.path.string()));
    }
    if (filled.size() == grid_.cells()) return;
    for (; !filled.empty(); filled.pop_front()) {
        const glm::ivec2 cell = filled.front();
        for (const glm::ivec2 step : {glm::ivec2{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
            const glm::ivec2 next = cell + step;
            const bool inside = next.x >= 0 && next.x < grid_.nx && next.y >= 0 && next.y < grid_.ny;
            if (!inside || weights_(next.x, next.y) > 0) continue;
            sums_(next.x, next.y) = sums_(cell.x, cell.y);
            weights_(next.x, next.y) = 1;
            filled.push_back(next);
        }
    }
}

}  // namespace waterlight
