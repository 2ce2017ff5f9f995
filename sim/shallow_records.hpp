// What shallow water has reached since the start: keeps ShallowRecords step by step.
#pragma once

#include "sim/shallow_solver.hpp"

namespace waterlight {

/// Of nothing yet.
ShallowRecords empty_records(int nx, int ny);

/// Adds the state at time_s.
template <class Real>
void add_records(const ShallowConstants& constants, const ShallowStart<Real>& start, const ShallowFields<Real>& now,
                 double time_s, ShallowRecords& records);

extern template void add_records<float>(const ShallowConstants&, const ShallowStart<float>&,
                                        const ShallowFields<float>&, double, ShallowRecords&);
extern template void add_records<double>(const ShallowConstants&, const ShallowStart<double>&,
                                         const ShallowFields<double>&, double, ShallowRecords&);

}  // namespace waterlight
