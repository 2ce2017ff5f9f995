#include "sim/shallow_sides.hpp"

#include <algorithm>

#include "sim/kernels/shallow_sides.hpp"
#include "sim/kernels/shallow_water.hpp"

namespace waterlight {

namespace {

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

/// The water beyond a side of each kind, from the water inside. u is the velocity into the domain.
struct Beyond {
    double time_s, gravity, ground, inward;
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
        return {{inside.h, 2 * side.displacement_m.rate_at(time_s) - inside.u}, inside_v};
    }
    Water wave(double elevation_m) const {
        const double coming_in = f64::incident_characteristic(-ground, elevation_m, gravity);
        return {f64::side_water(inside, coming_in, gravity), inside_v};
    }
};

}  // namespace

Boundary boundary_of(const ShallowSides& sides) {
    return {side_of(sides.west, sides.east), side_of(sides.south, sides.north)};
}

template <class Real>
ShallowFrames<Real>::ShallowFrames(const Grid& grid, const ShallowSides& sides, double gravity_m_s2, double film_m)
    : grid_(grid), sides_(sides), gravity_(gravity_m_s2), film_(film_m) {}

namespace {

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

template <class Real>
double ShallowFrames<Real>::fill(const ShallowStart<Real>& start, double time_s, ShallowFields<Real>& fields) const {
    double fastest = 0;
    for_sides(grid_, sides_, [&](const ShallowSide& side, const SideView& view) {
        FramedRows<Real>& across = view.along_y ? fields.qx : fields.qy;
        FramedRows<Real>& along = view.along_y ? fields.qy : fields.qx;
        const double inward = view.inward();
        const bool copies = is_periodic(side) || std::holds_alternative<WallSide>(side);
        const Real sign = is_periodic(side) ? Real(1) : Real(-1);
        for (int frame = -2; frame < 0; ++frame) {
            const int depth = source_of(side, view, frame);
            for (int n = 0; n < view.count(); ++n) {
                const Place from = view.at(n, depth), to = view.at(n, frame);
                if (copies) {
                    value(fields.rise, to) = value(fields.rise, from);
                    value(across, to) = sign * value(across, from);
                    value(along, to) = value(along, from);
                    continue;
                }
                const double h = static_cast<double>(value(start.depth, from)) + value(fields.rise, from);
                const double ground = static_cast<double>(value(start.surface, from)) - value(start.depth, from);
                const double flow = f64::flow_per_discharge(h, film_);
                const Beyond beyond{time_s,
                                    gravity_,
                                    ground,
                                    inward,
                                    view.along_y,
                                    {h, inward * flow * value(across, from)},
                                    flow * value(along, from)};
                const auto water = std::visit(beyond, side);
                value(fields.rise, to) = static_cast<Real>(water.at.h - value(start.depth, to));
                value(across, to) = static_cast<Real>(inward * water.at.h * water.at.u);
                value(along, to) = static_cast<Real>(water.at.h * water.v);
                const double u = view.along_y ? water.at.u : water.v, v = view.along_y ? water.v : water.at.u;
                fastest =
                    std::max(fastest, f64::crossing_rate(water.at.h, u, v, gravity_, 1 / grid_.dx_m, 1 / grid_.dy_m));
            }
        }
    });
    return fastest;
}

template class ShallowFrames<float>;
template class ShallowFrames<double>;

}  // namespace waterlight
