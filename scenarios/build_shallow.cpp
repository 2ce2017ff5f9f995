#include "scenarios/build_shallow.hpp"

#include <cmath>
#include <numbers>

#include "scenarios/resolve.hpp"
#include "sim/shallow_means.hpp"
#include "sim/shallow_waves.hpp"

namespace waterlight {

namespace {

/// Samples of a period: linear interpolation between them misses the sine by less than 1e-3 of the amplitude.
constexpr int samples_a_period = 80;

/// The oscillation from the start of the run to a period after its end, so that its side stays as it is.
TimeSeries oscillation(const Signal& signal, double duration_s) {
    const double period = *signal.period_s, ramp = signal.ramp_periods * period;
    const int samples = samples_a_period * (static_cast<int>(std::ceil(duration_s / period)) + 1);
    TimeSeries series;
    for (int i = 0; i <= samples; ++i) {
        const double t = i * period / samples_a_period;
        const double swell = t < ramp ? 0.5 * (1 - std::cos(std::numbers::pi * t / ramp)) : 1;
        series.time_s.push_back(t);
        series.value.push_back(signal.amplitude_m * swell * std::sin(2 * std::numbers::pi * t / period));
    }
    return series;
}

/// From the start of the run until no more than 1e-6 of the height is left of the wave.
TimeSeries solitary(const Signal& signal, const Water& water) {
    SolitaryWave wave{.height_m = *signal.solitary_height_m, .depth_m = water.depth_m};
    wave.gravity_m_s2 = water.gravity_m_s2;
    constexpr double reach = 8;  // 1 / cosh^2 falls below 1e-6 there
    constexpr int samples = 400;
    const double kappa = std::sqrt(0.75 * wave.height_m / std::pow(wave.depth_m, 3));
    const double end = signal.crest_s + reach / (kappa * wave.speed_m_s());
    TimeSeries series;
    for (int i = 0; i <= samples; ++i) {
        series.time_s.push_back(i * end / samples);
        series.value.push_back(wave.elevation_m(0, 0, series.time_s.back() - signal.crest_s));
    }
    return series;
}

TimeSeries series_of(const Signal& signal, const Scenario& s) {
    if (signal.file) return read_time_series(*signal.file, signal.scale);
    if (signal.constant) return constant_series(*signal.constant);
    return signal.period_s ? oscillation(signal, s.waves.duration_s) : solitary(signal, s.water);
}

ShallowSide inflow_side(const Inflow& inflow, const Scenario& s) {
    switch (inflow.kind) {
        case InflowKind::wave:
            return IncidentSide{series_of(inflow.signal, s)};
        case InflowKind::discharge:
            return DischargeSide{series_of(inflow.signal, s)};
        case InflowKind::level:
            return LevelSide{series_of(inflow.signal, s)};
        case InflowKind::piston:
            return PistonSide{series_of(inflow.signal, s)};
        case InflowKind::flow:
            break;
    }
    return FlowSide{inflow.elevation_m, inflow.velocity_m_s};
}

ShallowSide side_of(const Scenario& s, SideChoice choice, DomainSide side) {
    if (choice == SideChoice::wall) return WallSide{};
    if (choice == SideChoice::periodic) return PeriodicSide{};
    if (choice == SideChoice::absorbing) return OpenSide{};
    for (const Inflow& inflow : s.waves.inflows)
        if (inflow.side == side) return inflow_side(inflow, s);
    return WallSide{};
}

ShallowSides sides_of(const Scenario& s) {
    const SideChoices choices = resolve_sides(s);
    return {side_of(s, choices.west, DomainSide::west), side_of(s, choices.east, DomainSide::east),
            side_of(s, choices.south, DomainSide::south), side_of(s, choices.north, DomainSide::north)};
}

/// Bowls and the vortex have the domain's depth for their own.
struct WithDepth {
    double depth_m;
    void operator()(ThackerPlanar& state) const { state.h0_m = depth_m; }
    void operator()(ThackerRadial& state) const { state.h0_m = depth_m; }
    void operator()(TravellingVortex& state) const { state.h0_m = depth_m; }
    template <class State>
    void operator()(State&) const {}
};

/// How far the level 0 of an exact state lies below the scenario's: the flat ground of some is their level 0.
struct Shift {
    double depth_m;
    double operator()(const RiemannProblem&) const { return depth_m; }
    double operator()(const SteadyBump&) const { return depth_m; }
    double operator()(const ObliqueJump&) const { return depth_m; }
    template <class State>
    double operator()(const State&) const {
        return 0;
    }
};

std::optional<ExactStart> exact_start(const Scenario& s) {
    for (const ShallowInitial& initial : s.waves.initial)
        if (const auto* start = std::get_if<ExactStart>(&initial)) {
            ExactStart exact = *start;
            std::visit(WithDepth{s.domain.depth_m}, exact.state);
            exact.state = with_gravity(exact.state, s.water.gravity_m_s2);
            return exact;
        }
    return std::nullopt;
}

Field<double> bed_of(const ShallowExact& state, const Grid& grid, double depth_m) {
    Field<double> bed = bed_at_centres(state, grid);
    const double shift = std::visit(Shift{depth_m}, state);
    for (double& height : bed.values()) height -= shift;
    return bed;
}

}  // namespace

Field<double> stated_ground(const Scenario& s) {
    Bathymetry bathymetry{.depth_m = s.domain.depth_m, .file = std::nullopt, .shapes = s.domain.ground};
    if (s.domain.bathymetry) {
        bathymetry.file = s.domain.survey;
        bathymetry.file->path = *s.domain.bathymetry;
    }
    return ground_heights(bathymetry, grid_of(s));
}

ShallowWaterSettings shallow_settings(const Scenario& s) {
    ShallowWaterSettings settings;
    settings.grid = grid_of(s);
    settings.sides = sides_of(s);
    settings.water = s.water;
    settings.manning = s.waves.manning.value_or(0);
    settings.cfl = s.waves.cfl.value_or(settings.cfl);
    settings.wet_m = s.waves.wet_m.value_or(settings.wet_m);
    settings.keep_records = true;
    settings.sources = s.waves.sources;
    if (const std::optional<ExactStart> exact = exact_start(s)) {
        settings.bed_m = bed_of(exact->state, settings.grid, s.domain.depth_m);
        set_initial({*exact}, settings);
        return settings;
    }
    settings.bed_m = stated_ground(s);
    set_initial(s.waves.initial, settings);
    add_waves(s.waves.sines, s.waves.standing, settings);
    return settings;
}

std::optional<Field<double>> exact_depth(const Scenario& scenario, double time_s) {
    std::optional<ExactStart> exact = exact_start(scenario);
    if (!exact) return std::nullopt;
    return cell_means(exact->state, grid_of(scenario), exact->time_s + time_s).depth_m;
}

}  // namespace waterlight
