// Which settings of the model shallow-water go together.
#include <fmt/format.h>

#include <array>
#include <set>

#include "scenarios/combinations.hpp"
#include "scenarios/resolve.hpp"

namespace waterlight {

namespace {

constexpr std::array side_names{"west", "east", "south", "north"};

struct Axis {
    const char* name;
    const char *low, *high;
    SideChoice at_low, at_high;
};

/// The key that states a side, or the axis that does.
std::string key_of(const Scenario& s, const std::string& side, const std::string& axis) {
    const std::string own = "waves.boundary." + side;
    return s.origin.places.contains(own) ? own : "waves.boundary." + axis;
}

/// One of the axis that is stated.
std::string key_of(const Scenario& s, const Axis& axis) {
    const std::string low = key_of(s, axis.low, axis.name);
    return s.origin.places.contains(low) ? low : key_of(s, axis.high, axis.name);
}

void check_axis(const Scenario& s, const Axis& axis) {
    const auto is = [&](SideChoice choice) { return axis.at_low == choice || axis.at_high == choice; };
    if (is(SideChoice::periodic) && axis.at_low != axis.at_high)
        s.origin.reject(key_of(s, axis), fmt::format("periodic at one of {} and {}", axis.low, axis.high),
                        "periodic at both or none");
    if (resolve_model(s).model == ModelChoice::shallow_water) return;
    if (is(SideChoice::inflow)) require_model(s, true, key_of(s, axis), {ModelChoice::shallow_water});
    if (axis.at_low != axis.at_high)
        s.origin.reject(key_of(s, axis), fmt::format("{} and {} that differ", axis.low, axis.high),
                        "equal sides, or model shallow-water");
}

void check_signal(const Scenario& s, const Inflow& inflow, const std::string& key) {
    const Signal& signal = inflow.signal;
    int stated = 0;
    for (const bool is : {signal.file.has_value(), signal.constant.has_value(), signal.period_s.has_value(),
                          signal.solitary_height_m.has_value()})
        stated += is ? 1 : 0;
    const char* allowed = inflow.kind == InflowKind::discharge ? "one of file and discharge_m2_s"
                          : inflow.kind == InflowKind::level   ? "one of file and elevation_m"
                          : inflow.kind == InflowKind::piston  ? "one of file and period_s"
                                                               : "one of file, period_s and solitary_height_m";
    if (stated != 1) s.origin.reject(key, stated == 0 ? "nothing that comes in" : "more than one source", allowed);
    for (const char* name : {".amplitude_m", ".ramp_periods"})
        if (!signal.period_s && s.origin.places.contains(key + name))
            s.origin.reject(key + name, "it without period_s", "period_s beside it");
    if (!signal.solitary_height_m && s.origin.places.contains(key + ".crest_s"))
        s.origin.reject(key + ".crest_s", "it without solitary_height_m", "solitary_height_m beside it");
    if (!signal.file && s.origin.places.contains(key + ".scale"))
        s.origin.reject(key + ".scale", "it without a file", "file beside it");
}

void check_inflows(const Scenario& s) {
    const SideChoices sides = resolve_sides(s);
    const std::array choices{sides.west, sides.east, sides.south, sides.north};
    std::set<DomainSide> given;
    for (std::size_t i = 0; i < s.waves.inflows.size(); ++i) {
        const Inflow& inflow = s.waves.inflows[i];
        const std::string key = fmt::format("waves.inflow[{}]", i);
        const auto side = static_cast<std::size_t>(inflow.side);
        if (choices[side] != SideChoice::inflow)
            s.origin.reject(key + ".side", fmt::format("\"{}\", which is no inflow", side_names[side]),
                            fmt::format("a side with waves.boundary.{} = \"inflow\"", side_names[side]));
        if (!given.insert(inflow.side).second)
            s.origin.reject(key + ".side", fmt::format("\"{}\" twice", side_names[side]), "one inflow a side");
        if (inflow.kind != InflowKind::flow) check_signal(s, inflow, key);
    }
    for (std::size_t side = 0; side < choices.size(); ++side)
        if (choices[side] == SideChoice::inflow && !given.contains(static_cast<DomainSide>(side)))
            s.origin.reject(key_of(s, side_names[side], side < 2 ? "x" : "y"), "inflow of nothing",
                            fmt::format("[[waves.inflow]] with side = \"{}\" beside it", side_names[side]));
}

void check_shapes(const Scenario& s) {
    for (std::size_t i = 0; i < s.domain.ground.size(); ++i) {
        const auto* cone = std::get_if<ConeGround>(&s.domain.ground[i].ground);
        if (cone && cone->crest_radius_m > cone->toe_radius_m)
            s.origin.reject(fmt::format("domain.ground[{}].crest_radius_m", i), fmt::format("{}", cone->crest_radius_m),
                            fmt::format("at most toe_radius_m = {}", cone->toe_radius_m));
    }
}

/// An exact state is the whole of the water and the ground.
void check_initial(const Scenario& s) {
    const std::vector<ShallowInitial>& initial = s.waves.initial;
    for (std::size_t i = 0; i < initial.size(); ++i) {
        if (!std::holds_alternative<ExactStart>(initial[i])) continue;
        const std::string key = fmt::format("waves.initial[{}]", i);
        if (initial.size() > 1) s.origin.reject(key, "an exact state beside another state", "one exact state alone");
        if (s.domain.bathymetry || !s.domain.ground.empty())
            s.origin.reject(s.domain.bathymetry ? "domain.bathymetry" : "domain.ground",
                            "it beside an exact waves.initial, which has a ground of its own", "one of both");
        if (!s.waves.sines.empty() || !s.waves.standing.empty())
            s.origin.reject(s.waves.sines.empty() ? "waves.standing" : "waves.sine", "it beside an exact waves.initial",
                            "one of both");
    }
}

}  // namespace

void check_sides(const Scenario& s) {
    const SideChoices sides = resolve_sides(s);
    check_axis(s, {"x", "west", "east", sides.west, sides.east});
    check_axis(s, {"y", "south", "north", sides.south, sides.north});
}

void check_shallow(const Scenario& s) {
    const WavesSection& w = s.waves;
    const std::vector<ModelChoice> shallow{ModelChoice::shallow_water};
    require_model(s, w.manning.has_value(), "waves.manning", shallow);
    require_model(s, w.wet_m.has_value(), "waves.wet_m", shallow);
    require_model(s, !w.inflows.empty(), "waves.inflow", shallow);
    require_model(s, !w.initial.empty(), "waves.initial", shallow);
    const std::vector<ModelChoice> over_ground{ModelChoice::shallow_water, ModelChoice::prescribed};
    require_model(s, s.domain.bathymetry.has_value(), "domain.bathymetry", over_ground);
    require_model(s, !s.domain.ground.empty(), "domain.ground", over_ground);
    if (!s.domain.bathymetry && s.origin.places.contains("domain.survey"))
        s.origin.reject("domain.survey", "it without domain.bathymetry", "domain.bathymetry beside it");
    check_shapes(s);
    check_initial(s);
    for (const char* field : {"max_elevation", "max_speed", "arrival_time"})
        require_model(s, s.output.shows(field), "output.fields", shallow);
    check_inflows(s);
}

}  // namespace waterlight
