// Exact solutions of the shallow-water equations, each over its own ground (sim/kernels/shallow_exact.glsl).
//
// Each state offers the water at any place (m) and time (s), and bed(x, y), the height (m) of the ground above level 0.
// Where the ground is dry the velocity is zero. Parameters are in range as their comments say; check() throws
// InputError where they are not, the other functions do not look.
#pragma once

#include <glm/vec2.hpp>
#include <limits>
#include <variant>

#include "sim/shallow_water.hpp"

namespace waterlight {

inline constexpr double standard_gravity_m_s2 = Water{}.gravity_m_s2;

/// Water whose plane surface goes round in a bowl (Thacker 1981). Level 0 is that of the water at rest: the ground lies
/// at h0 (r^2/a^2 - 1).
struct ThackerPlanar {
    double h0_m = 0.1;   ///< depth of the bowl's middle, > 0
    double a_m = 1;      ///< radius of the shore at rest, > 0
    double eta_m = 0.5;  ///< how far the middle of the wet circle goes from the bowl's, >= 0
    glm::dvec2 centre_m{2, 2};
    double gravity_m_s2 = standard_gravity_m_s2;

    ShallowState exact(double x, double y, double t) const;
    double bed(double x, double y) const;
    double period_s() const;
    void check() const;
};

/// Water that swings in the same bowl as a paraboloid (Thacker 1981). Level 0 is that of the water at rest.
struct ThackerRadial {
    double h0_m = 0.1;  ///< > 0
    double a_m = 1;     ///< > 0
    double r0_m = 0.8;  ///< radius of the shore at t = 0, in (0, a]: water is highest in the middle
    glm::dvec2 centre_m{2, 2};
    double gravity_m_s2 = standard_gravity_m_s2;

    ShallowState exact(double x, double y, double t) const;
    double bed(double x, double y) const;
    double period_s() const;
    void check() const;
};

/// A vortex of radius 1 m carried along by a uniform flow (Ricchiuto & Bollermann 2009, 2.3, as ryujin has it). Level 0
/// is that of the water far away; the ground is flat at -h0.
struct TravellingVortex {
    double h0_m = 2;              ///< > beta^2 e / (8 pi^2 g), or the middle falls dry
    double beta_m2_s = 2;         ///< strength: speed f r with f = beta/(2 pi) exp((1 - r^2)/2)
    double speed_m_s = 1;         ///< of the uniform flow, at least 0
    double direction_deg = 45;    ///< of the uniform flow, counter-clockwise from +x
    glm::dvec2 centre_m{-1, -1};  ///< at t = 0
    double gravity_m_s2 = standard_gravity_m_s2;

    ShallowState exact(double x, double y, double t) const;
    double bed(double x, double y) const;
    void check() const;
};

/// Two uniform states meet at t = 0 along a straight line on flat ground, which is level 0. Either may be dry.
struct RiemannProblem {
    double left_depth_m = 0.005;   ///< behind the line, >= 0
    double right_depth_m = 0.001;  ///< ahead of it, >= 0
    double left_velocity_m_s = 0;  ///< across the line, positive ahead
    double right_velocity_m_s = 0;
    glm::dvec2 at_m{5, 0};     ///< a point of the line
    double direction_deg = 0;  ///< from behind to ahead, counter-clockwise from +x
    double gravity_m_s2 = standard_gravity_m_s2;

    /// At t <= 0 the two states.
    ShallowState exact(double x, double y, double t) const;
    double bed(double x, double y) const;
    void check() const;

    /// Depth and velocity between the two waves; depth 0 where the ground is dry there.
    struct Middle {
        double depth_m;
        double velocity_m_s;
        double left_shock_m_s;   ///< NaN where the left wave is no shock
        double right_shock_m_s;  ///< NaN where the right wave is no shock
    };
    Middle middle() const;
};

/// A dam 5 mm high breaks over dry ground (Ritter 1892).
inline RiemannProblem ritter() { return {.right_depth_m = 0}; }
/// A dam 5 mm high breaks over 1 mm of water (Stoker 1957).
inline RiemannProblem stoker() { return {}; }

enum class BumpRegime { subcritical, transcritical, transcritical_with_jump };

/// Steady flow towards +x over a parabolic bump (Goutal & Maurel 1997; SWASHES 3.1.3 to 3.1.5). Level 0 is the ground
/// away from the bump: z = max(0, height - curvature (x - crest)^2).
struct SteadyBump {
    double discharge_m2_s = 4.42;   ///< > 0
    double downstream_depth_m = 2;  ///< that held downstream, above critical; without effect where the flow there is
                                    ///< faster than its waves
    double height_m = 0.2;          ///< > 0
    double curvature_per_m = 0.05;  ///< > 0
    double crest_m = 10;
    double gravity_m_s2 = standard_gravity_m_s2;

    ShallowState exact(double x, double y, double t) const;
    double bed(double x, double y) const;
    void check() const;

    struct Flow {
        BumpRegime regime;
        double critical_depth_m;
        double upstream_head_m;                                    ///< h + q^2 / (2 g h^2) + z
        double downstream_head_m;                                  ///< lower by what the jump loses
        double jump_m = std::numeric_limits<double>::quiet_NaN();  ///< x of the jump, where there is one
    };
    Flow flow() const;
};

inline SteadyBump subcritical_bump() { return {}; }
inline SteadyBump transcritical_bump() { return {.discharge_m2_s = 1.53, .downstream_depth_m = 0.66}; }
inline SteadyBump jump_bump() { return {.discharge_m2_s = 0.18, .downstream_depth_m = 0.33}; }

/// Fast flow meets a wall at an angle and turns through a hydraulic jump (Ippen 1951). The wall runs along +x from the
/// corner, the water is north of it: the inflow heads for the wall, the flow behind the jump follows it. Level 0 is the
/// flat ground.
struct ObliqueJump {
    double depth_m = 1;            ///< of the inflow, > 0
    double speed_m_s = 8.57;       ///< of the inflow, above sqrt(g depth)
    double deflection_deg = 8.95;  ///< between inflow and wall, > 0, small enough for an attached jump
    glm::dvec2 corner_m{0, 0};
    double gravity_m_s2 = standard_gravity_m_s2;

    ShallowState exact(double x, double y, double t) const;
    double bed(double x, double y) const;
    void check() const;

    struct Behind {
        double angle_deg;  ///< from the inflow's direction to the jump; from the wall it is less by the deflection
        double depth_m;
        double speed_m_s;
    };
    Behind behind() const;
};

using ShallowExact =
    std::variant<ThackerPlanar, ThackerRadial, TravellingVortex, RiemannProblem, SteadyBump, ObliqueJump>;

/// The same state under another gravity.
ShallowExact with_gravity(ShallowExact state, double gravity_m_s2);

}  // namespace waterlight
