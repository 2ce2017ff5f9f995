#include "sim/shallow_sides.hpp"

#include <algorithm>
#include <cmath>

#include "sim/kernels/shallow_water.hpp"

namespace waterlight {

namespace shallow_sides {

bool is_walled(const ShallowSide& side) {
    return std::holds_alternative<WallSide>(side) || std::holds_alternative<PistonSide>(side);
}
bool is_periodic(const ShallowSide& side) { return std::holds_alternative<PeriodicSide>(side); }

Side side_of(const ShallowSide& low, const ShallowSide& high) {
    if (is_periodic(low)) return Side::periodic;
    return is_walled(low) || is_walled(high) ? Side::wall : Side::absorbing;
}

/// A place of the framed fields.
struct Place {
    int i, j;
};

/// One side: its n-th place of `count` along it, `depth` cells inward (0: at the side) or outward (-1, -2: the frame).
struct SideView {
    bool along_y;  // the side runs along y: west or east
    bool high;     // east or north
    int nx, ny;

    int count() const { return along_y ? ny : nx; }
    int across() const { return along_y ? nx : ny; }
    Place at(int n, int depth) const {
        const int k = high ? across() - 1 - depth : depth;
        return along_y ? Place{k, n} : Place{n, k};
    }
    double inward() const { return high ? -1 : 1; }
};

template <class Real>
Real& value(FramedRows<Real>& field, Place at) {
    return field.row(at.j)[at.i];
}
template <class Real>
Real value(const FramedRows<Real>& field, Place at) {
    return field.row(at.j)[at.i];
}

/// What each kind of side asks for. The velocity of a flow is turned into the side's own axes.
struct Demand {
    const SideView& view;
    const ShallowMoment& moment;

    using Result = f64::SideDemand;
    Result operator()(const WallSide&) const { return {BEYOND_WALL, 0, 0, 0}; }
    Result operator()(const PeriodicSide&) const { return {BEYOND_PERIODIC, 0, 0, 0}; }
    Result operator()(const OpenSide&) const { return {BEYOND_WAVE, 0, 0, 0}; }
    Result operator()(const IncidentSide& side) const {
        return {BEYOND_WAVE, moment.at_s <= side.elevation_m.end_s() ? side.elevation_m.at(moment.at_s) : 0, 0, 0};
    }
    Result operator()(const DischargeSide& side) const {
        return {BEYOND_DISCHARGE, side.discharge_m2_s.at(moment.at_s), 0, 0};
    }
    Result operator()(const LevelSide& side) const { return {BEYOND_LEVEL, side.elevation_m.at(moment.at_s), 0, 0}; }
    Result operator()(const FlowSide& side) const {
        const glm::dvec2 v = side.velocity_m_s;
        return {BEYOND_FLOW, side.elevation_m, view.inward() * (view.along_y ? v.x : v.y), view.along_y ? v.y : v.x};
    }
    Result operator()(const PistonSide& side) const { return {BEYOND_PISTON, mean_rate(side.displacement_m), 0, 0}; }

    double mean_rate(const TimeSeries& series) const {
        const auto [at_s, from_s, to_s] = moment;
        return to_s > from_s ? (series.at(to_s) - series.at(from_s)) / (to_s - from_s) : series.rate_at(at_s);
    }
};

}  // namespace shallow_sides

using namespace shallow_sides;
using f64::SideDemand;

Boundary boundary_of(const ShallowSides& sides) {
    return {side_of(sides.west, sides.east), side_of(sides.south, sides.north)};
}

bool has_series(const ShallowSides& sides) {
    const auto follows_one = [](const ShallowSide& side) {
        return std::holds_alternative<IncidentSide>(side) || std::holds_alternative<DischargeSide>(side) ||
               std::holds_alternative<LevelSide>(side) || std::holds_alternative<PistonSide>(side);
    };
    return follows_one(sides.west) || follows_one(sides.east) || follows_one(sides.south) || follows_one(sides.north);
}

namespace {

std::array<SideView, 4> views_of(const Grid& grid) {
    const int nx = grid.nx, ny = grid.ny;
    return {SideView{true, false, nx, ny}, {true, true, nx, ny}, {false, false, nx, ny}, {false, true, nx, ny}};
}

/// Calls work(demand, view) for the four sides.
template <class Work>
void for_sides(const SideDemands& demands, const Grid& grid, Work work) {
    const std::array<SideView, 4> views = views_of(grid);
    for (std::size_t n = 0; n < views.size(); ++n) work(demands[n], views[n]);
}

ShallowGate gate_of(const SideDemand& demand, const SideView& view) {
    if (demand.kind == BEYOND_DISCHARGE) return {true, view.inward() * demand.value};
    return {demand.kind == BEYOND_WALL, 0};
}

}  // namespace

SideDemands side_demands(const ShallowSides& sides, const ShallowMoment& moment) {
    const std::array<const ShallowSide*, 4> all{&sides.west, &sides.east, &sides.south, &sides.north};
    const std::array<SideView, 4> views = views_of({});
    SideDemands demands;
    for (std::size_t n = 0; n < all.size(); ++n) demands[n] = std::visit(Demand{views[n], moment}, *all[n]);
    return demands;
}

ShallowGates gates_of(const SideDemands& demands) {
    const std::array<SideView, 4> views = views_of({});
    return {gate_of(demands[0], views[0]), gate_of(demands[1], views[1]), gate_of(demands[2], views[2]),
            gate_of(demands[3], views[3])};
}

template <class Real>
ShallowFrames<Real>::ShallowFrames(const Grid& grid, double gravity_m_s2, double film_m)
    : grid_(grid), gravity_(gravity_m_s2), film_(film_m) {}

template <class Real>
void ShallowFrames<Real>::fill(const SideDemands& demands, ShallowStart<Real>& start) const {
    for_sides(demands, grid_, [&](const SideDemand& demand, const SideView& view) {
        for (int frame = -2; frame < 0; ++frame) {
            const int from = f64::frame_source(demand.kind, frame, view.across());
            for (int n = 0; n < view.count(); ++n) {
                value(start.surface, view.at(n, frame)) = value(start.surface, view.at(n, from));
                value(start.depth, view.at(n, frame)) = value(start.depth, view.at(n, from));
            }
        }
    });
}

namespace {

/// Copies the frame of one side: mirrored at a wall, repeated where periodic.
template <class Real>
void copy_frame(int kind, const SideView& view, ShallowFields<Real>& fields) {
    FramedRows<Real>& across = view.along_y ? fields.qx : fields.qy;
    FramedRows<Real>& along = view.along_y ? fields.qy : fields.qx;
    const Real sign = kind == BEYOND_PERIODIC ? Real(1) : Real(-1);
    for (int frame = -2; frame < 0; ++frame) {
        const int depth = f64::frame_source(kind, frame, view.across());
        for (int n = 0; n < view.count(); ++n) {
            const Place from = view.at(n, depth), to = view.at(n, frame);
            value(fields.rise, to) = value(fields.rise, from);
            value(across, to) = sign * value(across, from);
            value(along, to) = value(along, from);
        }
    }
}

bool copies(const SideDemand& demand) { return demand.kind == BEYOND_PERIODIC || demand.kind == BEYOND_WALL; }

/// Of two rates; a NaN is the largest.
double larger(double a, double b) { return std::isnan(a) || b <= a ? a : b; }

/// A cell of the state: the surface's rise and the discharge across and along a side.
struct Cell {
    double rise, across, along;
};

template <class Real>
Cell cell(const ShallowFields<Real>& f, const SideView& view, Place at) {
    const double x = value(f.qx, at), y = value(f.qy, at);
    return {value(f.rise, at), view.along_y ? x : y, view.along_y ? y : x};
}

template <class Real>
void set_cell(const Cell& cell, const SideView& view, Place at, ShallowFields<Real>& f) {
    value(f.rise, at) = static_cast<Real>(cell.rise);
    value(view.along_y ? f.qx : f.qy, at) = static_cast<Real>(cell.across);
    value(view.along_y ? f.qy : f.qx, at) = static_cast<Real>(cell.along);
}

}  // namespace

template <class Real>
template <class Inside, class Put>
double ShallowFrames<Real>::find_beyond(const SideDemand& demand, const SideView& view, const ShallowStart<Real>& start,
                                        const std::pair<Inside, Put>& cells) const {
    double fastest = 0;
    for (int frame = -2; frame < 0; ++frame) {
        const int depth = f64::frame_source(demand.kind, frame, view.across());
        for (int n = 0; n < view.count(); ++n) {
            const Place from = view.at(n, depth);
            const Cell inside = cells.first(from);
            const double surface = start.datum_m + value(start.surface, from), still = value(start.depth, from);
            const double h = std::max(still + inside.rise, 0.0);
            const double flow = f64::flow_per_discharge(h, film_);
            const f64::SideWater water{h, surface + inside.rise, still - surface, view.inward() * flow * inside.across,
                                       flow * inside.along};
            const f64::BeyondWater beyond = f64::beyond_side(demand, water, gravity_);
            const double rise = beyond.deeper > -h ? inside.rise + beyond.deeper : -still;  // dry to the last digit
            const double h_beyond = std::max(h + beyond.deeper, 0.0), u = view.inward() * beyond.u;
            cells.second(view.at(n, frame), Cell{rise, h_beyond * u, h_beyond * beyond.v});
            fastest =
                larger(fastest, f64::crossing_rate(h_beyond, view.along_y ? u : beyond.v, view.along_y ? beyond.v : u,
                                                   gravity_, 1 / grid_.dx_m, 1 / grid_.dy_m));
        }
    }
    return fastest;
}

template <class Real>
double ShallowFrames<Real>::fill(const SideDemands& demands, const ShallowStart<Real>& start,
                                 ShallowFields<Real>& now) const {
    double fastest = 0;
    for_sides(demands, grid_, [&](const SideDemand& demand, const SideView& view) {
        if (copies(demand)) return copy_frame(demand.kind, view, now);
        const auto inside = [&](Place at) { return cell(now, view, at); };
        const auto put = [&](Place at, const Cell& beyond) { set_cell(beyond, view, at, now); };
        fastest = larger(fastest, find_beyond(demand, view, start, std::pair{inside, put}));
    });
    return fastest;
}

template <class Real>
void ShallowFrames<Real>::fill(const SideDemands& demands, const ShallowStart<Real>& start,
                               const ShallowFields<Real>& now, ShallowFields<Real>& change) const {
    for_sides(demands, grid_, [&](const SideDemand& demand, const SideView& view) {
        if (copies(demand)) return copy_frame(demand.kind, view, change);
        const auto inside = [&](Place at) {
            const Cell a = cell(now, view, at), b = cell(change, view, at);
            return Cell{a.rise + b.rise, a.across + b.across, a.along + b.along};
        };
        const auto put = [&](Place at, const Cell& beyond) {
            const Cell a = cell(now, view, at);
            set_cell({beyond.rise - a.rise, beyond.across - a.across, beyond.along - a.along}, view, at, change);
        };
        find_beyond(demand, view, start, std::pair{inside, put});
    });
}

template class ShallowFrames<float>;
template class ShallowFrames<double>;

}  // namespace waterlight
