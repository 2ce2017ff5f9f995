// Standing waves and sines as initial states of the airy model.
#pragma once

#include "sim/airy_modes.hpp"
#include "sim/boundary.hpp"
#include "sim/sines.hpp"

namespace waterlight {

/// Exact: one mode, or two where the domain repeats. Throws InputError where a side absorbs, where a periodic side is
/// given an odd number of half waves, or where the grid is too coarse.
void add_standing(const StandingWave& wave, const Boundary& boundary, const AiryModes& modes, AiryState& state);

/// The sine's elevation and its quadrature, expanded in the modes: exact where the sides repeat; cut at walls, from
/// which it then reflects; faded to nothing in absorbing margins. Throws InputError where the sine does not fit a
/// periodic side, is frozen, or is shorter than two cells.
void add_sine(const Sine& sine, const Boundary& boundary, const AiryModes& modes, AiryState& state);

}  // namespace waterlight
