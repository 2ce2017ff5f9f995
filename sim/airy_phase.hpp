// Phases of many oscillators at one time.
#pragma once

namespace waterlight {

/// cosine[i] = cos(omega[i] elapsed_s), sine[i] = sin(omega[i] elapsed_s), i < count. The phase is reduced in double:
/// the error stays below 3e-7 as long as omega elapsed_s stays below 1e8. omega in rad/s.
void phase_row(const double* omega, int count, double elapsed_s, float* cosine, float* sine);

}  // namespace waterlight
