#include "sim/sources.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "sim/error.hpp"
#include "sim/kernels/sources.hpp"
#include "sim/random.hpp"

namespace waterlight {

namespace {

void require(bool holds, const char* what) {
    if (!holds) throw InputError(what);
}

void check(const Drop& drop) {
    require(drop.radius_m > 0 && std::isfinite(drop.radius_m), "drop: radius_m must be above 0");
    require(std::isfinite(drop.height_m), "drop: height_m must be a number");
    require(drop.time_s >= 0, "drop: time_s must be 0 or more");
}

void check(const Rain& rain) {
    require(rain.drops_per_m2_s > 0 && std::isfinite(rain.drops_per_m2_s), "rain: drops_per_m2_s must be above 0");
    require(rain.radius_m.x > 0 && rain.radius_m.y >= rain.radius_m.x, "rain: radius_m must be 0 < from <= to");
    require(rain.height_m.y >= rain.height_m.x, "rain: height_m must be from <= to");
    require(std::isfinite(rain.start_s) && rain.end_s >= rain.start_s, "rain: end_s must not be before start_s");
}

void check(const Wavemaker& maker) {
    require(glm::length(maker.to_m - maker.from_m) > 0, "wavemaker: from_m and to_m must differ");
    require(std::isfinite(maker.amplitude_m), "wavemaker: amplitude_m must be a number");
    require(maker.period_s > 0 && std::isfinite(maker.period_s), "wavemaker: period_s must be above 0");
    require(maker.ramp_periods >= 0, "wavemaker: ramp_periods must be 0 or more");
}

// Where a drop's centre and its images lie along one axis, as far as they reach into [start, start + size].
std::vector<double> images(double at, double start, double size, Side side, double reach) {
    std::vector<double> found;
    const auto add = [&](double x) {
        if (x > start - reach && x < start + size + reach) found.push_back(x);
    };
    if (side == Side::absorbing) {
        add(at);
        return found;
    }
    const int turns = static_cast<int>(std::ceil(reach / size)) + 1;
    const double period = side == Side::wall ? 2 * size : size;
    for (int n = -turns; n <= turns; ++n) {
        add(at + n * period);
        if (side == Side::wall) add(2 * start - at + n * period);
    }
    return found;
}

// The first and one past the last cell whose centre lies within `reach` of `at`.
std::pair<int, int> cells_within(double at, double reach, double start, double cell, int count) {
    const auto bound = [&](double x) {
        return static_cast<int>(std::clamp(std::ceil((x - start) / cell - 0.5), 0.0, static_cast<double>(count)));
    };
    return {bound(at - reach), bound(at + reach)};
}

// Samples of a shape without volume and of its footprint, from which the volume left by sampling is taken out.
struct Sampled {
    Field<double> value;
    Field<double> footprint;
    int i0 = 0;  // column and row of the grid where the samples start
    int j0 = 0;
};

void take_out_volume(Sampled& shape) {
    double volume = 0;
    double footprint = 0;
    for (const double v : shape.value.values()) volume += v;
    for (const double f : shape.footprint.values()) footprint += f;
    if (footprint <= 0) return;
    const double share = volume / footprint;
    const auto weights = shape.footprint.values();
    std::size_t n = 0;
    for (double& v : shape.value.values()) v -= share * weights[n++];
}

// exp(-q) and what multiplies it are below double rounding beyond q = 40.
constexpr double drop_reach_in_radii = 6.33;

Sampled sample(const Drop& drop, const Grid& grid, Boundary boundary) {
    const double reach = drop_reach_in_radii * drop.radius_m;
    const auto xs = images(drop.at_m.x, grid.x0_m, grid.width_m(), boundary.x, reach);
    const auto ys = images(drop.at_m.y, grid.y0_m, grid.height_m(), boundary.y, reach);
    int i0 = grid.nx, i1 = 0, j0 = grid.ny, j1 = 0;
    for (const double x : xs) {
        const auto [from, to] = cells_within(x, reach, grid.x0_m, grid.dx_m, grid.nx);
        i0 = std::min(i0, from);
        i1 = std::max(i1, to);
    }
    for (const double y : ys) {
        const auto [from, to] = cells_within(y, reach, grid.y0_m, grid.dy_m, grid.ny);
        j0 = std::min(j0, from);
        j1 = std::max(j1, to);
    }
    if (i1 <= i0 || j1 <= j0) return {};
    Sampled shape{Field<double>(i1 - i0, j1 - j0), Field<double>(i1 - i0, j1 - j0), i0, j0};
    const double per_radius2 = 1 / (drop.radius_m * drop.radius_m);
    for (const double y : ys) {
        const auto [from_j, to_j] = cells_within(y, reach, grid.y0_m, grid.dy_m, grid.ny);
        for (const double x : xs) {
            const auto [from_i, to_i] = cells_within(x, reach, grid.x0_m, grid.dx_m, grid.nx);
            for (int j = from_j; j < to_j; ++j) {
                for (int i = from_i; i < to_i; ++i) {
                    const double rx = grid.x_m(i) - x;
                    const double ry = grid.y_m(j) - y;
                    const double q = (rx * rx + ry * ry) * per_radius2;
                    shape.value(i - i0, j - j0) += drop.height_m * f64::drop_profile(q);
                    shape.footprint(i - i0, j - j0) += f64::drop_footprint(q);
                }
            }
        }
    }
    take_out_volume(shape);
    return shape;
}

}  // namespace

void require_valid(const Source& source) {
    std::visit([](const auto& s) { check(s); }, source);
}

std::vector<Drop> drops_of(const Rain& rain, const Grid& grid, double from_s, double to_s) {
    check(rain);
    const double begin = std::max(from_s, rain.start_s);
    const double end = std::min(to_s, rain.end_s);
    std::vector<Drop> drops;
    if (!(begin < end)) return drops;
    // A Poisson process is the union of independent ones over slices of time, each with its own stream of numbers:
    // any slice can be made without those before it. Within one, the gaps between drops are exponential.
    const double rate = rain.drops_per_m2_s * grid.width_m() * grid.height_m();
    const double slice_s = 16 / rate;
    const auto slice_of = [&](double t) { return static_cast<std::int64_t>(std::floor((t - rain.start_s) / slice_s)); };
    const std::int64_t last = slice_of(end) + 1;
    for (std::int64_t slice = std::max<std::int64_t>(slice_of(begin) - 1, 0); slice <= last; ++slice) {
        RandomStream random(rain.seed, static_cast<std::uint64_t>(slice));
        const double slice_start = rain.start_s + static_cast<double>(slice) * slice_s;
        for (double t = -std::log(1 - random.uniform()) / rate; t < slice_s;
             t -= std::log(1 - random.uniform()) / rate) {
            Drop drop;
            drop.at_m.x = grid.x0_m + random.uniform(0, grid.width_m());
            drop.at_m.y = grid.y0_m + random.uniform(0, grid.height_m());
            drop.radius_m = random.uniform(rain.radius_m.x, rain.radius_m.y);
            drop.height_m = random.uniform(rain.height_m.x, rain.height_m.y);
            drop.time_s = slice_start + t;
            if (drop.time_s >= begin && drop.time_s < end) drops.push_back(drop);
        }
    }
    std::stable_sort(drops.begin(), drops.end(), [](const Drop& a, const Drop& b) { return a.time_s < b.time_s; });
    return drops;
}

template <class Real>
void add_drop(const Drop& drop, const Grid& grid, Boundary boundary, Field<Real>& elevation_m) {
    check(drop);
    assert(elevation_m.nx() == grid.nx && elevation_m.ny() == grid.ny);
    const Sampled shape = sample(drop, grid, boundary);
    for (int j = 0; j < shape.value.ny(); ++j) {
        Real* to = elevation_m.row(shape.j0 + j) + shape.i0;
        const double* from = shape.value.row(j);
        for (int i = 0; i < shape.value.nx(); ++i) to[i] = static_cast<Real>(to[i] + from[i]);
    }
}

template void add_drop<float>(const Drop&, const Grid&, Boundary, Field<float>&);
template void add_drop<double>(const Drop&, const Grid&, Boundary, Field<double>&);

Wavemaker carried_on(const Wavemaker& maker, const Grid& domain) {
    check(maker);
    const auto at_side = [&](glm::dvec2 p) {
        return p.x <= domain.x_m(0) || p.x >= domain.x_m(domain.nx - 1) || p.y <= domain.y_m(0) ||
               p.y >= domain.y_m(domain.ny - 1);
    };
    const glm::dvec2 along = glm::normalize(maker.to_m - maker.from_m);
    const double far = 100 * (domain.width_m() + domain.height_m());
    Wavemaker longer = maker;
    if (at_side(maker.from_m)) longer.from_m -= far * along;
    if (at_side(maker.to_m)) longer.to_m += far * along;
    return longer;
}

Field<double> inflow_shape(const Wavemaker& maker, const Grid& grid, double wave_number, double group_velocity) {
    assert(wave_number > 0 && group_velocity > 0);
    const Wavemaker line = carried_on(maker, grid);
    const double length = glm::length(line.to_m - line.from_m);
    const glm::dvec2 along = (line.to_m - line.from_m) / length;
    // The width that couples best with the wave, k w = sqrt(2), and the transform of the profile at that k.
    const double width = std::numbers::sqrt2 / wave_number;
    const double transform = width * f64::wavemaker_transform(2);
    const double height = 2 * group_velocity * maker.amplitude_m / transform;
    Sampled shape{Field<double>(grid.nx, grid.ny), Field<double>(grid.nx, grid.ny), 0, 0};
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            const glm::dvec2 r = glm::dvec2(grid.x_m(i), grid.y_m(j)) - line.from_m;
            const double across = (r.x * along.y - r.y * along.x) / width;
            const double strength = f64::wavemaker_along(glm::dot(r, along), length, width);
            shape.value(i, j) = height * strength * f64::wavemaker_profile(across * across);
            shape.footprint(i, j) = strength * f64::wavemaker_footprint(across * across);
        }
    }
    take_out_volume(shape);
    return std::move(shape.value);
}

double inflow_signal(const Wavemaker& maker, double time_s) {
    const double t = time_s - maker.start_s;
    if (t < 0) return 0;
    const double ramp = maker.ramp_periods * maker.period_s;
    const double strength = t < ramp ? 0.5 * (1 - std::cos(std::numbers::pi * t / ramp)) : 1;
    const double phase = maker.phase_deg * std::numbers::pi / 180;
    return strength * std::cos(2 * std::numbers::pi * t / maker.period_s + phase);
}

}  // namespace waterlight
