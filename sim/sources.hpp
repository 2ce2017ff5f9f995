// What disturbs the water while a run goes on. Every source is mass-neutral.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <variant>
#include <vector>

#include "sim/boundary.hpp"
#include "sim/field.hpp"
#include "sim/grid.hpp"

namespace waterlight {

/// At time_s the elevation gains height (1 - r^2/R^2) exp(-r^2/R^2): a crater or a bump with its rim, of no volume.
struct Drop {
    glm::dvec2 at_m{0, 0};
    double radius_m = 0.1;   ///< R > 0
    double height_m = 0.01;  ///< at the centre; negative digs
    double time_s = 0;       ///< >= 0
};

/// Drops at random places and times (a Poisson process), the same for the same seed however the run is divided in
/// frames.
struct Rain {
    double drops_per_m2_s = 1;           ///< > 0
    glm::dvec2 radius_m{0.02, 0.05};     ///< drawn uniformly from [x, y]
    glm::dvec2 height_m{-0.01, -0.004};  ///< drawn uniformly from [x, y]
    double start_s = 0;
    double end_s = 1e30;
    std::uint64_t seed = 1;
};

/// A straight line of oscillating inflow that sends plane waves of amplitude_m to both sides. Its cross-section is the
/// second derivative of a Gaussian as wide as couples best with the wave it makes; it starts with a smooth ramp.
struct Wavemaker {
    glm::dvec2 from_m{0, 0};
    glm::dvec2 to_m{0, 1};  ///< differs from from_m
    double amplitude_m = 0.01;
    double period_s = 1;  ///< > 0
    double phase_deg = 0;
    double start_s = 0;
    double ramp_periods = 1;  ///< >= 0
};

using Source = std::variant<Drop, Rain, Wavemaker>;

/// Throws InputError where a number of the source is out of its range.
void require_valid(const Source& source);

/// Puts this rain in the place of all rain among the sources. Throws InputError as require_valid().
void replace_rain(std::vector<Source>& sources, std::span<const Rain> rain);

/// The drops of `rain` that fall on `grid` in [from_s, to_s), in order of time.
std::vector<Drop> drops_of(const Rain& rain, const Grid& grid, double from_s, double to_s);

/// What a drop adds to the cells around it: column i, row j of `elevation_m` belongs to cell (i0 + i, j0 + j).
struct DropPatch {
    int i0 = 0;
    int j0 = 0;
    Field<double> elevation_m;
};

/// The cells of `grid` that `drop` reaches: mirrored at walls, wrapped at periodic sides, cut off at absorbing ones.
/// What sampling leaves of its volume is taken out over its own footprint, so that the sum over the cells is zero.
DropPatch drop_patch(const Drop& drop, const Grid& grid, Boundary boundary);

/// Adds drop_patch() to the elevation (m) of `grid`.
template <class Real>
void add_drop(const Drop& drop, const Grid& grid, Boundary boundary, Field<Real>& elevation_m);

extern template void add_drop<float>(const Drop&, const Grid&, Boundary, Field<float>&);
extern template void add_drop<double>(const Drop&, const Grid&, Boundary, Field<double>&);

/// The same line; an end that is within a cell of a side of the domain, or beyond, is carried on a long way.
Wavemaker carried_on(const Wavemaker& maker, const Grid& domain);

/// Vertical inflow (m/s) of a wavemaker at full strength at the cell centres; its sum over the cells is zero. A forcing
/// eta_t + div q = s(x) cos(W t) sends waves of amplitude |transform of s at k| / (2 cg) to both sides; s is scaled so
/// that this is amplitude_m. The line ends smoothly over its own width, or runs on as in carried_on(). wave_number
/// (rad/m) and group_velocity (m/s) are the model's at the maker's period.
Field<double> inflow_shape(const Wavemaker& maker, const Grid& grid, double wave_number, double group_velocity);

/// What multiplies inflow_shape at time t: a raised-cosine ramp (1 - cos(pi (t - start) / ramp)) / 2, then 1, times
/// cos(W (t - start) + phase); zero before start_s.
double inflow_signal(const Wavemaker& maker, double time_s);

}  // namespace waterlight
