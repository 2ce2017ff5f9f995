// The water at the start of a shallow-water run.
#pragma once

#include <glm/vec2.hpp>
#include <variant>
#include <vector>

#include "sim/shallow_exact.hpp"

namespace waterlight {

/// Water at rest at one level (m); ground above it is dry.
struct StillWater {
    double level_m = 0;
};

/// Two levels of still water, parted by a straight dam that is gone at t = 0. At ground's height or below, a side is
/// dry.
struct PlaneDam {
    glm::dvec2 at_m{0, 0};     ///< a point of the dam
    double direction_deg = 0;  ///< from the level behind to that ahead, counter-clockwise from +x
    double behind_level_m = 1;
    double ahead_level_m = 0;
};

/// Two levels of still water, parted by a round dam.
struct CircularDam {
    glm::dvec2 centre_m{0, 0};
    double radius_m = 1;  ///< > 0
    double inside_level_m = 1;
    double outside_level_m = 0;
};

/// A solitary wave on water of one depth, with Boussinesq's profile: elevation a sech^2(kappa (s - s0)) with kappa =
/// sqrt(3 a / (4 d^3)), and velocity c elevation / (d + elevation) with c = sqrt(g (d + a)). That velocity is what a
/// wave of permanent form must have, since its discharge is c times its elevation; it is the choice of those who run
/// the conical island with shallow water (Nikolos & Delis 2009, 6.4; Hou et al. 2013, 3.4). The other in use,
/// velocity = elevation sqrt(g/d) (Synolakis 1987), is the same in the limit of small waves, but at the crest of a =
/// d/5 moves 9.5 % more water than the wave carries. A shallow-water model lacks the dispersion that keeps the form:
/// the front steepens as it travels.
struct SolitaryWave {
    glm::dvec2 crest_m{0, 0};  ///< a point of the crest
    double height_m = 0.1;     ///< a, > 0
    double depth_m = 1;        ///< d, > 0: of the still water where the wave starts
    double direction_deg = 0;  ///< counter-clockwise from +x
    double gravity_m_s2 = standard_gravity_m_s2;

    double speed_m_s() const;
    /// Above still water; the wave keeps its form. The series of a side is this at a place of it.
    double elevation_m(double x, double y, double t) const;
    glm::dvec2 velocity_m_s(double x, double y, double t) const;
    /// Of water above still water, per metre of crest: 2 a / kappa = 4 sqrt(a d^3 / 3).
    double volume_m2() const;
};

/// An exact state at a time of its own, as means over the cells.
struct ExactStart {
    ShallowExact state;
    double time_s = 0;
};

using ShallowInitial = std::variant<StillWater, PlaneDam, CircularDam, SolitaryWave, ExactStart>;

/// Fills depth and velocity of `settings`, whose grid, ground and gravity must be there. The states are put down in
/// turn, on water still at level 0: a solitary wave rides on the water that it finds and spares dry ground, every other
/// state replaces what it finds. Gravity is that of settings.water. Depth is
///   - of still water, level - ground at the cell's centre, so that a lake at rest is at rest whatever its ground; in
///     cells that a dam crosses, the mean by area;
///   - of exact states, the mean over the cell; velocity is mean discharge over mean depth. The ground must be the
///     state's own: bed_at_centres().
/// Throws InputError where a number is out of its range.
void set_initial(const std::vector<ShallowInitial>& initial, ShallowWaterSettings& settings);

}  // namespace waterlight
