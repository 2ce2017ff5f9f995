#include "sim/shallow_records.hpp"

#include <cmath>
#include <limits>

#include "sim/kernels/shallow_water.hpp"

namespace waterlight {

namespace {

using f32::flow_per_discharge;
using f64::flow_per_discharge;

constexpr float never = std::numeric_limits<float>::quiet_NaN();

template <class Real>
void add_row(const ShallowView<Real>& view, int j, float time_s, Real wet, ShallowRecords& records) {
    const Real* __restrict surface = view.start.surface.row(j);
    const Real* __restrict depth = view.start.depth.row(j);
    const Real* __restrict rise = view.now.rise.row(j);
    const Real* __restrict qx = view.now.qx.row(j);
    const Real* __restrict qy = view.now.qy.row(j);
    float* __restrict highest = records.max_elevation_m.row(j);
    float* __restrict fastest = records.max_speed_m_s.row(j);
    float* __restrict arrival = records.arrival_s.row(j);
    const Real film = static_cast<Real>(view.film_m);
    const float datum = static_cast<float>(view.start.datum_m);
#pragma GCC ivdep
    for (int i = 0; i < view.grid.nx; ++i) {
        const Real h = depth[i] + rise[i];
        const Real flow = flow_per_discharge(h, film);
        const bool wet_now = h > wet;
        const float e = static_cast<float>(surface[i] + rise[i]) + datum;
        const float speed = static_cast<float>(flow * std::sqrt(qx[i] * qx[i] + qy[i] * qy[i]));
        // A comparison with NaN fails: then the first value is taken.
        highest[i] = wet_now && !(e <= highest[i]) ? e : highest[i];
        fastest[i] = wet_now && speed > fastest[i] ? speed : fastest[i];
        const bool arrives = rise[i] > wet && wet_now;
        arrival[i] = arrives && !(arrival[i] <= time_s) ? time_s : arrival[i];
    }
}

}  // namespace

template <class Real>
ShallowRecords first_records(const ShallowView<Real>& view, double wet_m) {
    const auto field = [&](float value) {
        Field<float> f(view.grid.nx, view.grid.ny);
        f.fill(value);
        return f;
    };
    ShallowRecords records{field(never), field(0), field(never)};
    add_records(view, 0, wet_m, records);
    return records;
}

template <class Real>
void add_records(const ShallowView<Real>& view, double time_s, double wet_m, ShallowRecords& records) {
#pragma omp parallel for schedule(static)
    for (int j = 0; j < view.grid.ny; ++j)
        add_row(view, j, static_cast<float>(time_s), static_cast<Real>(wet_m), records);
}

template ShallowRecords first_records<float>(const ShallowView<float>&, double);
template ShallowRecords first_records<double>(const ShallowView<double>&, double);
template void add_records<float>(const ShallowView<float>&, double, double, ShallowRecords&);
template void add_records<double>(const ShallowView<double>&, double, double, ShallowRecords&);

}  // namespace waterlight
