// What a scenario says about the sides of the shallow-water model.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>

namespace waterlight {

enum class DomainSide { west, east, south, north };

/// What is stated for a side; as Side, and inflow beside.
enum class SideChoice { periodic, wall, absorbing, inflow };

struct SideChoices {
    SideChoice west = SideChoice::wall, east = SideChoice::wall, south = SideChoice::wall, north = SideChoice::wall;
    bool operator==(const SideChoices&) const = default;
};

/// A number in time: one of a file, a constant, an oscillation and a solitary wave.
struct Signal {
    std::optional<std::string> file;  ///< two columns, time (s) and value
    double scale = 1;                 ///< multiplies the file's values
    std::optional<double> constant;
    double amplitude_m = 0;                   ///< of amplitude sin(2 pi t / period)
    std::optional<double> period_s;           ///< none: no oscillation
    double ramp_periods = 1;                  ///< over which it swells as (1 - cos(pi t / ramp)) / 2
    std::optional<double> solitary_height_m;  ///< of a solitary wave on water as deep as the domain
    double crest_s = 0;                       ///< when its crest passes the side
};

/// wave: one that comes in; after its end the side is open. discharge, level, flow: as DischargeSide, LevelSide and
/// FlowSide of the model. piston: a wall that moves.
enum class InflowKind { wave, discharge, level, flow, piston };

/// What comes in at one side.
struct Inflow {
    DomainSide side = DomainSide::west;
    InflowKind kind = InflowKind::wave;
    Signal signal;                  ///< of all kinds but flow
    double elevation_m = 0;         ///< of flow
    glm::dvec2 velocity_m_s{0, 0};  ///< of flow
};

}  // namespace waterlight
