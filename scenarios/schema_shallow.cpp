#include "scenarios/schema_shallow.hpp"

#include "scenarios/schema_parts.hpp"

namespace waterlight::schema {

namespace {

void describe_inflow_side(Visitor& v, Inflow& s) {
    v.value({.name = "side", .meaning = "Where; its waves.boundary is inflow.", .required = true},
            choice(s.side, {"west", "east", "south", "north"}));
}

void describe_file(Visitor& v, Signal& s, std::string_view meaning) {
    v.value({"file", "", meaning, {}, false, "none"}, &s.file);
    v.value({"scale", "", "Multiplies the file's values."}, &s.scale);
}

void describe_oscillation(Visitor& v, Signal& s) {
    v.value({"amplitude_m", "m", "Instead of a file: a of a sin(2 pi t / period)."}, &s.amplitude_m);
    v.value({"period_s", "s", "Its period.", positive, false, "none"}, &s.period_s);
    v.value({"ramp_periods", "", "Periods over which it swells to its amplitude.", not_negative}, &s.ramp_periods);
}

void describe_wave(Visitor& v, Inflow& s) {
    describe_inflow_side(v, s);
    describe_file(v, s.signal,
                  "Time (s) and elevation (m) in two columns; beside the scenario or below $WATERLIGHT_DATA.");
    describe_oscillation(v, s.signal);
    v.value({"solitary_height_m", "m", "Instead: height of a solitary wave on water of domain.depth_m.", positive,
             false, "none"},
            &s.signal.solitary_height_m);
    v.value({"crest_s", "s", "When its crest passes the side.", not_negative}, &s.signal.crest_s);
}

void describe_discharge(Visitor& v, Inflow& s) {
    describe_inflow_side(v, s);
    v.value({"discharge_m2_s", "m2/s", "Into the domain, per metre of side.", {}, false, "none"}, &s.signal.constant);
    describe_file(v, s.signal, "Instead: time (s) and discharge (m2/s) in two columns, found as that of a wave.");
}

void describe_level(Visitor& v, Inflow& s) {
    describe_inflow_side(v, s);
    v.value({"elevation_m", "m", "At which the water is held.", {}, false, "none"}, &s.signal.constant);
    describe_file(v, s.signal, "Instead: time (s) and elevation (m) in two columns, found as that of a wave.");
}

void describe_flow(Visitor& v, Inflow& s) {
    describe_inflow_side(v, s);
    v.value({"elevation_m", "m", "Of the water beyond the side."}, &s.elevation_m);
    v.value({"velocity_m_s", "m/s", "Along x and y.", {}, true}, &s.velocity_m_s);
}

void describe_piston(Visitor& v, Inflow& s) {
    describe_inflow_side(v, s);
    describe_file(v, s.signal,
                  "Time (s) and displacement (m) into the domain in two columns, found as that of a wave.");
    describe_oscillation(v, s.signal);
}

template <class Describe>
Visitor::Inside append_inflow(std::vector<Inflow>& inflows, InflowKind kind, Describe describe_one) {
    return append<Inflow>(inflows, [kind, describe_one](Visitor& v, Inflow& s) {
        s.kind = kind;
        describe_one(v, s);
    });
}

}  // namespace

void describe_sides(Visitor& v, WavesSection& s) {
    const std::vector<std::string_view> names{"periodic", "wall", "absorbing", "inflow"};
    v.value({"x", "", "Both x sides."}, choice_or("auto", s.boundary_x, names));
    v.value({"y", "", "Both y sides."}, choice_or("auto", s.boundary_y, names));
    v.value({"west", "", "The side of least x; auto is what x says."}, choice_or("auto", s.boundary_west, names));
    v.value({"east", "", "The side of greatest x; auto is what x says."}, choice_or("auto", s.boundary_east, names));
    v.value({"south", "", "The side of least y; auto is what y says."}, choice_or("auto", s.boundary_south, names));
    v.value({"north", "", "The side of greatest y; auto is what y says."}, choice_or("auto", s.boundary_north, names));
}

void describe_shallow(Visitor& v, WavesSection& s) {
    v.value({"manning", "s/m^(1/3)", "Manning's roughness of the ground; model shallow-water only.", not_negative,
             false, "0, no friction"},
            &s.manning);
    v.value({"wet_m", "m", "Depth from which ground counts as inundated; model shallow-water only.", positive, false,
             "0.001"},
            &s.wet_m);
    v.list({"inflow", "", "What comes in at a side; model shallow-water."},
           {{"wave", "A wave; what runs against it leaves. After the end of a file the side is open.",
             append_inflow(s.inflows, InflowKind::wave, describe_wave)},
            {"discharge", "A river.", append_inflow(s.inflows, InflowKind::discharge, describe_discharge)},
            {"level", "A lake or a weir.", append_inflow(s.inflows, InflowKind::level, describe_level)},
            {"flow", "Flow of a given state, as faster flow than its waves needs it.",
             append_inflow(s.inflows, InflowKind::flow, describe_flow)},
            {"piston", "A wall that moves.", append_inflow(s.inflows, InflowKind::piston, describe_piston)}});
    describe_initial(v, s.initial);
}

}  // namespace waterlight::schema
