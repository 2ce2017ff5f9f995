// What shallow water has reached since the start: keeps ShallowRecords step by step.
#pragma once

#include "sim/shallow_surface.hpp"

namespace waterlight {

/// Of the initial state.
template <class Real>
ShallowRecords first_records(const ShallowView<Real>& view, double wet_m);

/// Adds the state at time_s.
template <class Real>
void add_records(const ShallowView<Real>& view, double time_s, double wet_m, ShallowRecords& records);

}  // namespace waterlight
