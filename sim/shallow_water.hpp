// Nonlinear shallow water over real ground, wet and dry.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "sim/sources.hpp"
#include "sim/time_series.hpp"
#include "sim/water.hpp"
#include "sim/wave_model.hpp"

namespace waterlight {

/// What happens at one side of the domain.
struct WallSide {};
/// The opposite side is periodic too.
struct PeriodicSide {};
/// Open: waves leave along their characteristics; beyond it the water is still at level 0, or the ground is dry.
struct OpenSide {};
/// A wave comes in, of the given elevation (m) when it is alone; what runs against it leaves. After the end of the
/// series the side is open.
struct IncidentSide {
    TimeSeries elevation_m;
};
/// A river: discharge per metre of side (m2/s) into the domain.
struct DischargeSide {
    TimeSeries discharge_m2_s;
};
/// The water is held at an elevation (m), as by a lake or a weir.
struct LevelSide {
    TimeSeries elevation_m;
};
/// Flow of a given state, as faster flow than its waves needs it.
struct FlowSide {
    double elevation_m = 0;
    glm::dvec2 velocity_m_s{0, 0};
};
/// A wall that moves: displacement (m) into the domain, small against the domain; it stands still before and after.
struct PistonSide {
    TimeSeries displacement_m;
};
using ShallowSide =
    std::variant<WallSide, PeriodicSide, OpenSide, IncidentSide, DischargeSide, LevelSide, FlowSide, PistonSide>;

struct ShallowSides {
    ShallowSide west, east, south, north;
};

/// Depth (m, >= 0) and velocity (m/s) of the water at a place or as means over a cell.
struct ShallowState {
    double depth_m = 0;
    glm::dvec2 velocity_m_s{0, 0};
};

/// Fields of the grid's size. Empty ones: no bed_m is flat ground at -water.depth_m; no depth_m is water still at level
/// 0; no velocity is water at rest.
struct ShallowWaterSettings {
    Grid grid;
    ShallowSides sides;
    Water water;            ///< gravity and density
    Field<double> bed_m;    ///< height of the ground above level 0, negative below it
    Field<double> depth_m;  ///< initial depth of the water, >= 0
    Field<double> velocity_x_m_s;
    Field<double> velocity_y_m_s;
    double manning = 0;         ///< roughness n, s/m^(1/3), >= 0
    double cfl = 0.8;           ///< dt max((|u| + c)/dx + (|v| + c)/dy), in (0, 1]
    double wet_m = 1e-3;        ///< depth from which ground counts as inundated, > 0
    bool keep_records = false;  ///< whether records() is kept, step by step
    std::vector<Source> sources;
};

/// What the water has reached since the start, over all steps. Values of cells.
struct ShallowRecords {
    Field<float> max_elevation_m;  ///< of the water while it is deeper than wet_m; NaN where it never was
    Field<float> max_speed_m_s;    ///< while it is deeper than wet_m; 0 where it never was
    Field<float> arrival_s;  ///< when it first was deeper than wet_m on ground that was dry at the start, or first
                             ///< rose by wet_m above its initial elevation elsewhere; NaN where it never did
};

/// Integrals over the domain, in double.
struct ShallowTotals {
    double volume_m3 = 0;  ///< of the water
    double momentum_x_kg_m_s = 0;
    double momentum_y_kg_m_s = 0;
    double potential_j = 0;  ///< above that of water still at level 0
    double kinetic_j = 0;
    double inundated_m2 = 0;  ///< cells deeper than wet_m
};

/// Second-order finite volumes (sim/kernels/shallow_water.glsl). Real is float (production) or double (reference).
class ShallowWaterModel : public WaveModel {
  public:
    /// Of cell (i, j), in the model's own precision.
    virtual ShallowState state(int i, int j) const = 0;
    virtual double bed_m(int i, int j) const = 0;
    /// The length (s) of the last step, or before the first that of the longest allowed.
    virtual double step_s() const = 0;
    virtual ShallowTotals totals() const = 0;
    /// None unless settings asked for them. Valid until the next advance().
    virtual const ShallowRecords* records() const = 0;
};

/// Throws InputError where a setting is out of its range. advance() throws WorldError where a step would be shorter
/// than 1e-9 of the time in which a wave of the initial water crosses a cell, or where a number is not finite: the text
/// names the cell and its state.
template <class Real>
std::unique_ptr<ShallowWaterModel> make_shallow_water(const ShallowWaterSettings& settings);

extern template std::unique_ptr<ShallowWaterModel> make_shallow_water<float>(const ShallowWaterSettings&);
extern template std::unique_ptr<ShallowWaterModel> make_shallow_water<double>(const ShallowWaterSettings&);

}  // namespace waterlight
