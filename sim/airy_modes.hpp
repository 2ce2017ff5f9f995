// The modes of the airy model: products of one slot along x and one along y, each a free oscillator.
#pragma once

#include <glm/vec2.hpp>

#include "sim/boundary.hpp"
#include "sim/fft_axis.hpp"
#include "sim/fft_plane.hpp"
#include "sim/field.hpp"
#include "sim/grid.hpp"
#include "sim/water.hpp"

namespace waterlight {

struct AiryModes {
    Water water;
    Grid tank;            ///< the grid and its hidden margins
    PlaneWindow visible;  ///< where the grid lies in the tank
    AxisBasis x, y;
    Field<double> omega;  ///< rad/s; x.distinct() by y.distinct()

    double area_m2() const { return x.length_m() * y.length_m(); }
};

/// margin_cells: on each side, along x and y; 0 where there is none.
AiryModes make_airy_modes(const Grid& grid, const Boundary& boundary, const Water& water, glm::ivec2 margin_cells);

/// The state of all modes, constant while nothing disturbs the water:
/// elevation = a cos(w (t - start)) + b sin(w (t - start)). In double, and never stepped, so that time costs no
/// accuracy. Slot (i, j) is the product of x slot i and y slot j.
struct AiryState {
    Field<double> a, b;
    double start_s = 0;
};

/// elevation slots at time_s; and, where `quadrature` is given, of rate / w, the elevation a quarter period later, sign
/// turned. Planes are those of a PlaneTransform.
void evaluate_modes(const AiryModes& modes, const AiryState& state, double time_s, Field<float>& elevation,
                    Field<float>* quadrature);

/// (density / 2) (g + s k^2) e^2 summed over the modes of the whole tank, J: of a plane of elevations its potential and
/// capillary energy; of a plane of rate / w the kinetic, since rate^2 / (k tanh kh) = (g + s k^2) (rate / w)^2.
double plane_energy_j(const AiryModes& modes, const Field<float>& plane);

}  // namespace waterlight
