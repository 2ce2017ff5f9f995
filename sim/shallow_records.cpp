#include "sim/shallow_records.hpp"

#include <cmath>
#include <limits>

#include "sim/kernels/shallow_records.hpp"
#include "sim/kernels/shallow_water.hpp"

namespace waterlight {

namespace {

using f32::flow_per_discharge;
using f64::flow_per_discharge;

constexpr float never = std::numeric_limits<float>::quiet_NaN();

template <class Real>
void add_row(const ShallowConstants& constants, const ShallowStart<Real>& start, const ShallowFields<Real>& now, int j,
             float time_s, ShallowRecords& records) {
    const Real* __restrict surface = start.surface.row(j);
    const Real* __restrict depth = start.depth.row(j);
    const Real* __restrict rise = now.rise.row(j);
    const Real* __restrict qx = now.qx.row(j);
    const Real* __restrict qy = now.qy.row(j);
    float* __restrict highest = records.max_elevation_m.row(j);
    float* __restrict fastest = records.max_speed_m_s.row(j);
    float* __restrict arrival = records.arrival_s.row(j);
    const Real film = static_cast<Real>(constants.film), wet = static_cast<Real>(constants.wet);
    const int nx = now.rise.nx();
    const float datum = static_cast<float>(start.datum_m);
#pragma GCC ivdep
    for (int i = 0; i < nx; ++i) {
        const Real h = depth[i] + rise[i];
        const Real flow = flow_per_discharge(h, film);
        const Real speed = flow * std::sqrt(qx[i] * qx[i] + qy[i] * qy[i]);
        const bool wet_now = h > wet, arrived = wet_now && rise[i] > wet;
        const f32::CellRecord r =
            f32::with_state({highest[i], fastest[i], arrival[i]}, static_cast<float>(surface[i] + rise[i]) + datum,
                            static_cast<float>(speed), wet_now, arrived, time_s);
        highest[i] = r.highest;
        fastest[i] = r.fastest;
        arrival[i] = r.arrival;
    }
}

}  // namespace

ShallowRecords empty_records(int nx, int ny) {
    ShallowRecords records{{nx, ny}, {nx, ny}, {nx, ny}};
    records.max_elevation_m.fill(never);
    records.arrival_s.fill(never);
    return records;
}

template <class Real>
void add_records(const ShallowConstants& constants, const ShallowStart<Real>& start, const ShallowFields<Real>& now,
                 double time_s, ShallowRecords& records) {
#pragma omp parallel for schedule(static)
    for (int j = 0; j < now.rise.ny(); ++j) add_row(constants, start, now, j, static_cast<float>(time_s), records);
}

template void add_records<float>(const ShallowConstants&, const ShallowStart<float>&, const ShallowFields<float>&,
                                 double, ShallowRecords&);
template void add_records<double>(const ShallowConstants&, const ShallowStart<double>&, const ShallowFields<double>&,
                                  double, ShallowRecords&);

}  // namespace waterlight
