#include "sim/shallow_sides.hpp"

#include <algorithm>

#include "sim/kernels/shallow_sides.hpp"
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

/// Where the frame takes its values from: the depth (SideView) of the place that stands for frame cell -1 or -2.
int source_of(const ShallowSide& side, const SideView& view, int frame) {
    if (is_periodic(side)) return view.across() + frame < 0 ? 0 : view.across() + frame;
    return is_walled(side) ? std::min(-1 - frame, view.across() - 1) : 0;
}

/// A time, and the step it belongs to.
struct Moment {
    double time_s;
    ShallowMoment step;
};

double mean_rate(const TimeSeries& series, const ShallowMoment& step) {
    if (!(step.to_s > step.from_s)) return series.rate_at(step.from_s);
    return (series.at(step.to_s) - series.at(step.from_s)) / (step.to_s - step.from_s);
}

/// The water beyond a side of each kind, from the water inside. u is the velocity into the domain.
struct Beyond {
    double time_s;
    ShallowMoment step;
    double gravity, ground, inward;
    bool along_y;
    f64::SideWater inside;
    double inside_v;  // along the side

    struct Water {
        f64::SideWater at;
        double v;
    };
    Water operator()(const WallSide&) const { return {{inside.h, -inside.u}, inside_v}; }
    Water operator()(const PeriodicSide&) const { return {inside, inside_v}; }
    Water operator()(const OpenSide&) const { return wave(0); }
    Water operator()(const IncidentSide& side) const {
        return wave(time_s <= side.elevation_m.end_s() ? side.elevation_m.at(time_s) : 0);
    }
    Water operator()(const DischargeSide& side) const {
        return {f64::river_water(inside, side.discharge_m2_s.at(time_s), gravity), 0};
    }
    Water operator()(const LevelSide& side) const {
        const f64::SideWater at = f64::held_water(inside, side.elevation_m.at(time_s) - ground, gravity);
        return {at, at.u > 0 ? 0 : inside_v};
    }
    Water operator()(const FlowSide& side) const {
        const glm::dvec2 v = side.velocity_m_s;
        const double across = along_y ? v.x : v.y, along = along_y ? v.y : v.x;
        return {{std::max(side.elevation_m - ground, 0.0), inward * across}, along};
    }
    Water operator()(const PistonSide& side) const {
        return {{inside.h, 2 * mean_rate(side.displacement_m, step) - inside.u}, inside_v};
    }
    Water wave(double elevation_m) const {
        const double coming_in = f64::incident_characteristic(-ground, elevation_m, gravity);
        return {f64::side_water(inside, coming_in, gravity), inside_v};
    }
};

}  // namespace shallow_sides

using namespace shallow_sides;

Boundary boundary_of(const ShallowSides& sides) {
    return {side_of(sides.west, sides.east), side_of(sides.south, sides.north)};
}

template <class Real>
ShallowFrames<Real>::ShallowFrames(const Grid& grid, const ShallowSides& sides, double gravity_m_s2, double film_m)
    : grid_(grid), sides_(sides), gravity_(gravity_m_s2), film_(film_m) {}

namespace {

ShallowGate gate_of(const ShallowSide& side, double inward, double time_s) {
    if (const auto* river = std::get_if<DischargeSide>(&side)) return {true, inward * river->discharge_m2_s.at(time_s)};
    return {std::holds_alternative<WallSide>(side), 0};
}

/// Calls work(side, view) for the four sides.
template <class Work>
void for_sides(const Grid& grid, const ShallowSides& sides, Work work) {
    work(sides.west, SideView{true, false, grid.nx, grid.ny});
    work(sides.east, SideView{true, true, grid.nx, grid.ny});
    work(sides.south, SideView{false, false, grid.nx, grid.ny});
    work(sides.north, SideView{false, true, grid.nx, grid.ny});
}

}  // namespace

template <class Real>
ShallowGates ShallowFrames<Real>::gates(double time_s) const {
    return {gate_of(sides_.west, 1, time_s), gate_of(sides_.east, -1, time_s), gate_of(sides_.south, 1, time_s),
            gate_of(sides_.north, -1, time_s)};
}

template <class Real>
void ShallowFrames<Real>::fill(ShallowStart<Real>& start) const {
    for_sides(grid_, sides_, [&](const ShallowSide& side, const SideView& view) {
        for (int frame = -2; frame < 0; ++frame) {
            const int from = source_of(side, view, frame);
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
void copy_frame(const ShallowSide& side, const SideView& view, ShallowFields<Real>& fields) {
    FramedRows<Real>& across = view.along_y ? fields.qx : fields.qy;
    FramedRows<Real>& along = view.along_y ? fields.qy : fields.qx;
    const Real sign = is_periodic(side) ? Real(1) : Real(-1);
    for (int frame = -2; frame < 0; ++frame) {
        const int depth = source_of(side, view, frame);
        for (int n = 0; n < view.count(); ++n) {
            const Place from = view.at(n, depth), to = view.at(n, frame);
            value(fields.rise, to) = value(fields.rise, from);
            value(across, to) = sign * value(across, from);
            value(along, to) = value(along, from);
        }
    }
}

bool copies(const ShallowSide& side) { return is_periodic(side) || std::holds_alternative<WallSide>(side); }

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
double ShallowFrames<Real>::find_beyond(const ShallowSide& side, const SideView& view, const ShallowStart<Real>& start,
                                        const Moment& moment, const std::pair<Inside, Put>& cells) const {
    double fastest = 0;
    for (int frame = -2; frame < 0; ++frame) {
        for (int n = 0; n < view.count(); ++n) {
            const Place from = view.at(n, source_of(side, view, frame)), to = view.at(n, frame);
            const Cell inside = cells.first(from);
            const double still = value(start.depth, from);
            const double h = still + inside.rise;
            const double flow = f64::flow_per_discharge(h, film_);
            const Beyond beyond{moment.time_s,
                                moment.step,
                                gravity_,
                                start.datum_m + value(start.surface, from) - still,
                                view.inward(),
                                view.along_y,
                                {h, view.inward() * flow * inside.across},
                                flow * inside.along};
            const Beyond::Water water = std::visit(beyond, side);
            const double u = view.inward() * water.at.u;
            cells.second(to, Cell{water.at.h - value(start.depth, to), water.at.h * u, water.at.h * water.v});
            fastest =
                std::max(fastest, f64::crossing_rate(water.at.h, view.along_y ? u : water.v, view.along_y ? water.v : u,
                                                     gravity_, 1 / grid_.dx_m, 1 / grid_.dy_m));
        }
    }
    return fastest;
}

template <class Real>
double ShallowFrames<Real>::fill(const ShallowStart<Real>& start, const ShallowMoment& step,
                                 ShallowFields<Real>& now) const {
    double fastest = 0;
    for_sides(grid_, sides_, [&](const ShallowSide& side, const SideView& view) {
        if (copies(side)) return copy_frame(side, view, now);
        const auto inside = [&](Place at) { return cell(now, view, at); };
        const auto put = [&](Place at, const Cell& beyond) { set_cell(beyond, view, at, now); };
        fastest = std::max(fastest, find_beyond(side, view, start, {step.from_s, step}, std::pair{inside, put}));
    });
    return fastest;
}

template <class Real>
void ShallowFrames<Real>::fill(const ShallowStart<Real>& start, const ShallowMoment& step,
                               const ShallowFields<Real>& now, ShallowFields<Real>& change) const {
    for_sides(grid_, sides_, [&](const ShallowSide& side, const SideView& view) {
        if (copies(side)) return copy_frame(side, view, change);
        const auto inside = [&](Place at) {
            const Cell a = cell(now, view, at), b = cell(change, view, at);
            return Cell{a.rise + b.rise, a.across + b.across, a.along + b.along};
        };
        const auto put = [&](Place at, const Cell& beyond) {
            const Cell a = cell(now, view, at);
            set_cell({beyond.rise - a.rise, beyond.across - a.across, beyond.along - a.along}, view, at, change);
        };
        find_beyond(side, view, start, {step.to_s, step}, std::pair{inside, put});
    });
}

template <class Real>
bool ShallowFrames<Real>::has_series() const {
    const auto moves = [](const ShallowSide& side) {
        return std::holds_alternative<IncidentSide>(side) || std::holds_alternative<DischargeSide>(side) ||
               std::holds_alternative<LevelSide>(side) || std::holds_alternative<PistonSide>(side);
    };
    return moves(sides_.west) || moves(sides_.east) || moves(sides_.south) || moves(sides_.north);
}

template class ShallowFrames<float>;
template class ShallowFrames<double>;

}  // namespace waterlight
