#include "sim/sources.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "sim/error.hpp"
#include "sim/kernels/sources.hpp"
#include "sim/random.hpp"
#include "sim/round_spot.hpp"

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

// Samples of a shape without volume and of its footprint.
struct Sampled {
    Field<double> value;
    Field<double> footprint;
};

// The shape without the volume that sampling left in it, which is taken out in proportion to the footprint.
Field<double> without_volume(Sampled shape) {
    double volume = 0;
    double footprint = 0;
    for (const double v : shape.value.values()) volume += v;
    for (const double f : shape.footprint.values()) footprint += f;
    if (footprint <= 0) return std::move(shape.value);
    const double share = volume / footprint;
    const auto weights = shape.footprint.values();
    std::size_t n = 0;
    for (double& v : shape.value.values()) v -= share * weights[n++];
    return std::move(shape.value);
}

}  // namespace

void require_valid(const Source& source) {
    std::visit([](const auto& s) { check(s); }, source);
}

void replace_rain(std::vector<Source>& sources, std::span<const Rain> rain) {
    std::erase_if(sources, [](const Source& source) { return std::holds_alternative<Rain>(source); });
    for (const Rain& each : rain) {
        check(each);
        sources.emplace_back(each);
    }
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

DropPatch drop_patch(const Drop& drop, const Grid& grid, Boundary boundary) {
    check(drop);
    const RoundSpot spot(drop.at_m, drop.radius_m, grid, boundary);
    const int nx = spot.columns().to - spot.columns().from, ny = spot.rows().to - spot.rows().from;
    if (nx <= 0 || ny <= 0) return {};
    Sampled shape{Field<double>(nx, ny), Field<double>(nx, ny)};
    spot.visit([&](int i, int j, double q) {
        shape.value(i - spot.columns().from, j - spot.rows().from) += drop.height_m * f64::drop_profile(q);
        shape.footprint(i - spot.columns().from, j - spot.rows().from) += f64::drop_footprint(q);
    });
    return {spot.columns().from, spot.rows().from, without_volume(std::move(shape))};
}

template <class Real>
void add_drop(const Drop& drop, const Grid& grid, Boundary boundary, Field<Real>& elevation_m) {
    assert(elevation_m.nx() == grid.nx && elevation_m.ny() == grid.ny);
    const DropPatch patch = drop_patch(drop, grid, boundary);
    for (int j = 0; j < patch.elevation_m.ny(); ++j) {
        Real* to = elevation_m.row(patch.j0 + j) + patch.i0;
        const double* from = patch.elevation_m.row(j);
        for (int i = 0; i < patch.elevation_m.nx(); ++i) to[i] = static_cast<Real>(to[i] + from[i]);
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
    Sampled shape{Field<double>(grid.nx, grid.ny), Field<double>(grid.nx, grid.ny)};
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            const glm::dvec2 r = glm::dvec2(grid.x_m(i), grid.y_m(j)) - line.from_m;
            const double across = (r.x * along.y - r.y * along.x) / width;
            const double strength = f64::wavemaker_along(glm::dot(r, along), length, width);
            shape.value(i, j) = height * strength * f64::wavemaker_profile(across * across);
            shape.footprint(i, j) = strength * f64::wavemaker_footprint(across * across);
        }
    }
    return without_volume(std::move(shape));
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
