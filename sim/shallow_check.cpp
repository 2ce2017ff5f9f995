#include "sim/shallow_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/error.hpp"
#include "sim/kernels/shallow_water.hpp"

namespace waterlight {

namespace {

void require(bool holds, std::string_view what, double found, std::string_view allowed) {
    if (!holds) throw InputError(fmt::format("{}: found {}; allowed: {}", what, found, allowed));
}

bool fits(const Field<double>& field, const Grid& grid) {
    return field.empty() || (field.nx() == grid.nx && field.ny() == grid.ny);
}

void check_fields(const ShallowWaterSettings& s) {
    for (const auto& [name, field] :
         {std::pair{"bed", &s.bed_m}, std::pair{"depth", &s.depth_m}, std::pair{"velocity along x", &s.velocity_x_m_s},
          std::pair{"velocity along y", &s.velocity_y_m_s}}) {
        if (!fits(*field, s.grid))
            throw InputError(fmt::format("{}: found {} x {} values; allowed: as many as cells, {} x {}", name,
                                         field->nx(), field->ny(), s.grid.nx, s.grid.ny));
        for (const double value : field->values()) require(std::isfinite(value), name, value, "finite numbers");
    }
    for (const double depth : s.depth_m.values()) require(depth >= 0, "depth", depth, ">= 0");
}

void check_series(std::string_view what, const TimeSeries& series) {
    if (series.empty() || series.value.size() != series.time_s.size())
        throw InputError(fmt::format("{}: found {} times and {} values; allowed: as many of both, at least one", what,
                                     series.time_s.size(), series.value.size()));
    for (const double value : series.value) require(std::isfinite(value), what, value, "finite numbers");
    for (std::size_t n = 0; n < series.time_s.size(); ++n)
        require(std::isfinite(series.time_s[n]) && (n == 0 || series.time_s[n] > series.time_s[n - 1]), what,
                series.time_s[n], "times that increase");
}

struct SideCheck {
    void operator()(const WallSide&) const {}
    void operator()(const PeriodicSide&) const {}
    void operator()(const OpenSide&) const {}
    void operator()(const IncidentSide& side) const { check_series("incident wave of a side", side.elevation_m); }
    void operator()(const DischargeSide& side) const {
        check_series("discharge of a side", side.discharge_m2_s);
        for (const double q : side.discharge_m2_s.value) require(q >= 0, "discharge of a side", q, ">= 0 m2/s");
    }
    void operator()(const LevelSide& side) const { check_series("level of a side", side.elevation_m); }
    void operator()(const FlowSide& side) const {
        for (const double value : {side.elevation_m, side.velocity_m_s.x, side.velocity_m_s.y})
            require(std::isfinite(value), "flow of a side", value, "finite numbers");
    }
    void operator()(const PistonSide& side) const { check_series("piston of a side", side.displacement_m); }
};

void check_sides(const ShallowSides& s) {
    const auto periodic = [](const ShallowSide& side) { return std::holds_alternative<PeriodicSide>(side); };
    if (periodic(s.west) != periodic(s.east) || periodic(s.south) != periodic(s.north))
        throw InputError("sides: found one periodic side without its opposite; allowed: both or none of an axis");
    for (const ShallowSide* side : {&s.west, &s.east, &s.south, &s.north}) std::visit(SideCheck{}, *side);
}

double deepest_m(const ShallowWaterSettings& s) {
    double deepest = 0;
    for (int j = 0; j < s.grid.ny; ++j)
        for (int i = 0; i < s.grid.nx; ++i) deepest = std::max(deepest, initial_depth_m(s, i, j));
    return deepest;
}

}  // namespace

double initial_bed_m(const ShallowWaterSettings& s, int i, int j) {
    return s.bed_m.empty() ? -s.water.depth_m : s.bed_m(i, j);
}

double initial_depth_m(const ShallowWaterSettings& s, int i, int j) {
    return s.depth_m.empty() ? std::max(0.0, -initial_bed_m(s, i, j)) : s.depth_m(i, j);
}

void check_shallow(const ShallowWaterSettings& s) {
    require(s.cfl > 0 && s.cfl <= 1, "cfl", s.cfl, "above 0, at most 1");
    require(s.manning >= 0 && std::isfinite(s.manning), "manning", s.manning, ">= 0");
    require(s.wet_m > 0 && std::isfinite(s.wet_m), "wet_m", s.wet_m, "> 0");
    require(s.water.gravity_m_s2 > 0 && std::isfinite(s.water.gravity_m_s2), "gravity", s.water.gravity_m_s2, "> 0");
    const double density = s.water.density_kg_m3;
    require(density > 0 && std::isfinite(density), "density", density, "> 0");
    if (s.bed_m.empty())
        require(s.water.depth_m > 0 && std::isfinite(s.water.depth_m), "depth", s.water.depth_m,
                "> 0 and finite; deep water is for airy");
    check_fields(s);
    check_sides(s.sides);
    for (const Source& source : s.sources) require_valid(source);
}

double film_depth(const ShallowWaterSettings& s) {
    constexpr double part = 1e-5, thinnest = 1e-17;
    return std::max(part * std::min(1.0, deepest_m(s)), thinnest);
}

double still_rate(const ShallowWaterSettings& s) {
    const double deepest = deepest_m(s);
    const double h = deepest > 0 ? deepest : std::min(s.grid.dx_m, s.grid.dy_m);
    return f64::crossing_rate(h, 0, 0, s.water.gravity_m_s2, 1 / s.grid.dx_m, 1 / s.grid.dy_m);
}

namespace {

/// The initial level of water that is nearest to 0; where all is dry, 0.
double nearest_level_m(const ShallowWaterSettings& s) {
    double nearest = std::numeric_limits<double>::infinity();
    for (int j = 0; j < s.grid.ny; ++j) {
        for (int i = 0; i < s.grid.nx; ++i) {
            const double h = initial_depth_m(s, i, j), level = initial_bed_m(s, i, j) + h;
            if (h > 0 && std::abs(level) < std::abs(nearest)) nearest = level;
        }
    }
    return std::isfinite(nearest) ? nearest : 0;
}

}  // namespace

template <class Real>
void set_start(const ShallowWaterSettings& s, ShallowStart<Real>& start, ShallowFields<Real>& fields) {
    start.datum_m = nearest_level_m(s);
    for (int j = 0; j < s.grid.ny; ++j) {
        for (int i = 0; i < s.grid.nx; ++i) {
            const double h = initial_depth_m(s, i, j);
            start.depth.row(j)[i] = static_cast<Real>(h);
            start.surface.row(j)[i] = static_cast<Real>(initial_bed_m(s, i, j) + h - start.datum_m);
            fields.qx.row(j)[i] = static_cast<Real>(s.velocity_x_m_s.empty() ? 0 : h * s.velocity_x_m_s(i, j));
            fields.qy.row(j)[i] = static_cast<Real>(s.velocity_y_m_s.empty() ? 0 : h * s.velocity_y_m_s(i, j));
        }
    }
}

template void set_start<float>(const ShallowWaterSettings&, ShallowStart<float>&, ShallowFields<float>&);
template void set_start<double>(const ShallowWaterSettings&, ShallowStart<double>&, ShallowFields<double>&);

}  // namespace waterlight
