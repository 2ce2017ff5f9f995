// The states from which the model shallow-water starts.
#include "scenarios/schema_parts.hpp"
#include "scenarios/schema_shallow.hpp"

namespace waterlight::schema {

namespace {

constexpr std::string_view angle = "From behind to ahead, counter-clockwise from +x.";

void describe_still(Visitor& v, StillWater& s) {
    v.value({"level_m", "m", "Elevation of the water; ground above it is dry."}, &s.level_m);
}

void describe_dam(Visitor& v, PlaneDam& s) {
    v.value({"at_m", "m", "A point of the dam.", {}, true}, &s.at_m);
    v.value({"direction_deg", "deg", angle, circle}, &s.direction_deg);
    v.value({"behind_level_m", "m", "Level behind the dam."}, &s.behind_level_m);
    v.value({"ahead_level_m", "m", "Level ahead of it; at ground's height or below, that is dry."}, &s.ahead_level_m);
}

void describe_circular_dam(Visitor& v, CircularDam& s) {
    v.value({"centre_m", "m", "Centre of the dam.", {}, true}, &s.centre_m);
    v.value({"radius_m", "m", "Its radius.", positive}, &s.radius_m);
    v.value({"inside_level_m", "m", "Level inside the dam."}, &s.inside_level_m);
    v.value({"outside_level_m", "m", "Level outside; at ground's height or below, that is dry."}, &s.outside_level_m);
}

void describe_solitary(Visitor& v, SolitaryWave& s) {
    v.value({"crest_m", "m", "A point of its crest.", {}, true}, &s.crest_m);
    v.value({"height_m", "m", "Height of the crest above still water.", positive}, &s.height_m);
    v.value({"depth_m", "m", "Of the still water where it starts.", positive, false, "domain.depth_m"}, &s.depth_m);
    v.value({"direction_deg", "deg", "Direction of travel, counter-clockwise from +x.", circle}, &s.direction_deg);
}

void describe_thacker(Visitor& v, ThackerPlanar& s) {
    v.value({"centre_m", "m", "Centre of the bowl, whose middle is domain.depth_m deep.", {}, true}, &s.centre_m);
    v.value({"a_m", "m", "Radius of the shore at rest.", positive}, &s.a_m);
    v.value({"eta_m", "m", "How far the middle of the wet circle goes from the bowl's.", not_negative}, &s.eta_m);
}

void describe_thacker_radial(Visitor& v, ThackerRadial& s) {
    v.value({"centre_m", "m", "Centre of the bowl, whose middle is domain.depth_m deep.", {}, true}, &s.centre_m);
    v.value({"a_m", "m", "Radius of the shore at rest.", positive}, &s.a_m);
    v.value({"r0_m", "m", "Radius of the shore at time 0, at most a_m.", positive}, &s.r0_m);
}

void describe_vortex(Visitor& v, TravellingVortex& s) {
    v.value({"centre_m", "m", "Its middle at time 0; the water far away is domain.depth_m deep.", {}, true},
            &s.centre_m);
    v.value({"beta_m2_s", "m2/s", "Strength: speed beta/(2 pi) exp((1 - r2)/2) r."}, &s.beta_m2_s);
    v.value({"speed_m_s", "m/s", "Of the flow that carries it.", not_negative}, &s.speed_m_s);
    v.value({"direction_deg", "deg", "Of that flow, counter-clockwise from +x.", circle}, &s.direction_deg);
}

void describe_riemann(Visitor& v, RiemannProblem& s) {
    v.value({"at_m", "m", "A point of the line.", {}, true}, &s.at_m);
    v.value({"direction_deg", "deg", angle, circle}, &s.direction_deg);
    v.value({"left_depth_m", "m", "Depth behind the line; the ground lies at -domain.depth_m.", not_negative},
            &s.left_depth_m);
    v.value({"right_depth_m", "m", "Depth ahead of it.", not_negative}, &s.right_depth_m);
    v.value({"left_velocity_m_s", "m/s", "Behind the line, positive ahead."}, &s.left_velocity_m_s);
    v.value({"right_velocity_m_s", "m/s", "Ahead of it, positive ahead."}, &s.right_velocity_m_s);
}

void describe_bump(Visitor& v, SteadyBump& s) {
    v.value({"discharge_m2_s", "m2/s", "Towards +x.", positive}, &s.discharge_m2_s);
    v.value({"downstream_depth_m", "m", "Depth held downstream; the ground away from the bump lies at -domain.depth_m.",
             positive},
            &s.downstream_depth_m);
    v.value({"height_m", "m", "Height of the bump.", positive}, &s.height_m);
    v.value({"curvature_per_m", "1/m", "Its ground is height - curvature (x - crest)2.", positive}, &s.curvature_per_m);
    v.value({"crest_m", "m", "x of its crest."}, &s.crest_m);
}

void describe_jump(Visitor& v, ObliqueJump& s) {
    v.value({"corner_m", "m", "Where the wall begins; it runs along +x, the water is north of it."}, &s.corner_m);
    v.value({"flow_depth_m", "m", "Depth of the inflow; the ground lies at -domain.depth_m.", positive}, &s.depth_m);
    v.value({"speed_m_s", "m/s", "Speed of the inflow, faster than its waves.", positive}, &s.speed_m_s);
    v.value({"deflection_deg", "deg", "Between inflow and wall.", {.low = 0, .high = 90, .excludes_low = true}},
            &s.deflection_deg);
}

/// An exact state at a time of its own.
template <class State, class Describe>
Visitor::Inside append_exact(std::vector<ShallowInitial>& initial, Describe describe_one) {
    return [&initial, describe_one](Visitor& v) {
        State state;
        ExactStart start;
        describe_one(v, state);
        v.value({"time_s", "s", "Time of the exact state at the start of the run.", not_negative}, &start.time_s);
        start.state = state;
        initial.emplace_back(start);
    };
}

}  // namespace

void describe_initial(Visitor& v, std::vector<ShallowInitial>& s) {
    v.list(
        {"initial", "",
         "The water at the start, put down in turn on water still at level 0; model shallow-water. The exact states "
         "stand alone, bring their own ground, and are compared with at the end (waves.exact_l1)."},
        {{"still", "Water at rest.", append<StillWater>(s, describe_still)},
         {"dam", "Two levels parted by a straight dam that is gone at the start.", append<PlaneDam>(s, describe_dam)},
         {"circular-dam", "Two levels parted by a round dam.", append<CircularDam>(s, describe_circular_dam)},
         {"solitary", "A solitary wave, on the water that is there.", append<SolitaryWave>(s, describe_solitary)},
         {"thacker", "Exact: a plane surface that goes round in a bowl (Thacker 1981).",
          append_exact<ThackerPlanar>(s, describe_thacker)},
         {"thacker-radial", "Exact: a paraboloid that swings in a bowl (Thacker 1981).",
          append_exact<ThackerRadial>(s, describe_thacker_radial)},
         {"vortex", "Exact: a vortex carried along by a flow.", append_exact<TravellingVortex>(s, describe_vortex)},
         {"riemann", "Exact: two states that meet along a line (dam breaks of Ritter and Stoker).",
          append_exact<RiemannProblem>(s, describe_riemann)},
         {"bump", "Exact: steady flow over a bump.", append_exact<SteadyBump>(s, describe_bump)},
         {"oblique-jump", "Exact: fast flow that a wall turns through a jump.",
          append_exact<ObliqueJump>(s, describe_jump)}});
}

}  // namespace waterlight::schema
