#include "sim/airy_sources.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "sim/airy_dispersion.hpp"
#include "sim/airy_phase.hpp"
#include "sim/kernels/sources.hpp"

namespace waterlight {

namespace {

constexpr double pi = std::numbers::pi;

/// Coefficients of a point at x along an axis: the slot's value there over its mean square and the length.
std::vector<double> point_coefficients(const AxisBasis& axis, double x_m) {
    std::vector<double> coefficients(static_cast<std::size_t>(axis.n));
    for (int slot = 0; slot < axis.n; ++slot)
        coefficients[static_cast<std::size_t>(slot)] =
            axis.value(slot, x_m) / (axis.mean_square(slot) * axis.length_m());
    return coefficients;
}

/// k^2 of each distinct wave number along an axis.
std::vector<double> squared_wave_numbers(const AxisBasis& axis) {
    std::vector<double> k2;
    for (int wave = 0; wave < axis.distinct(); ++wave) k2.push_back(axis.wave_number(wave) * axis.wave_number(wave));
    return k2;
}

/// A drop or a push as the modes see it.
struct SpotModes {
    SpotModes(const Drop& drop, const AiryModes& modes, double elapsed)
        : SpotModes(drop.at_m, drop.radius_m, modes, elapsed) {
        volume_scale = drop.height_m * pi * drop.radius_m * drop.radius_m;
    }
    SpotModes(const Push& push, const AiryModes& modes, double elapsed)
        : SpotModes(push.at_m, push.radius_m, modes, elapsed) {
        volume_scale = push.volume_m3;
        is_push = true;
    }

    std::vector<double> x, y;
    double q_per_k2, elapsed_s;
    double volume_scale = 0;
    bool is_push = false;

  private:
    SpotModes(glm::dvec2 at_m, double radius_m, const AiryModes& modes, double elapsed)
        : x(point_coefficients(modes.x, at_m.x)),
          y(point_coefficients(modes.y, at_m.y)),
          q_per_k2(0.25 * radius_m * radius_m),
          elapsed_s(elapsed) {}
};

/// Where q exp(-q) has fallen below 1e-13 of its largest value.
constexpr double q_negligible = 34;

/// cos(w t) and sin(w t), t the time of the spot, times its transform, for one row of distinct modes.
template <class Transform>
void spot_row(const SpotModes& spot, const double* omega, std::span<const double> kx2, double ky2, float* c, float* s,
              Transform transform) {
    const int count = static_cast<int>(kx2.size());
    phase_row(omega, count, spot.elapsed_s, c, s);
    const auto q_y = static_cast<float>(spot.q_per_k2 * ky2);
    const auto scale = static_cast<float>(spot.volume_scale), q_per_k2 = static_cast<float>(spot.q_per_k2);
    const double* k2 = kx2.data();
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const float amplitude = scale * transform(q_y + q_per_k2 * static_cast<float>(k2[i]));
        c[i] *= amplitude;
        s[i] *= amplitude;
    }
}

void add_row(int n, double weight, const double* __restrict x, const float* __restrict c, const float* __restrict s,
             double* __restrict a, double* __restrict b) {
#pragma GCC ivdep
    for (int i = 0; i < n; ++i) {
        a[i] += weight * x[i] * c[i];
        b[i] += weight * x[i] * s[i];
    }
}

/// sin(x) / x
double sinc(double x) { return std::abs(x) < 1e-4 ? 1 - x * x / 6 : std::sin(x) / x; }

/// The constant mode, whose transform a push has, takes none.
void add_spots(const AiryModes& modes, std::span<const SpotModes> spots, AiryState& state) {
    const double level = state.a.row(0)[0];
    const std::vector<double> kx2 = squared_wave_numbers(modes.x), ky2 = squared_wave_numbers(modes.y);
#pragma omp parallel
    {
        Field<float> phase(modes.x.n, 2);
        float *c = phase.row(0), *s = phase.row(1);
#pragma omp for schedule(static)
        for (int wave = 0; wave < modes.y.distinct(); ++wave) {
            for (const SpotModes& spot : spots) {
                const double row_k2 = ky2[static_cast<std::size_t>(wave)];
                if (spot.q_per_k2 * row_k2 > q_negligible) continue;
                const double* omega = modes.omega.row(wave);
                if (spot.is_push)
                    spot_row(spot, omega, kx2, row_k2, c, s, [](float q) { return f32::push_transform(q); });
                else
                    spot_row(spot, omega, kx2, row_k2, c, s, [](float q) { return f32::drop_transform(q); });
                spread_to_slots(modes.x, c);
                spread_to_slots(modes.x, s);
                const int partner = modes.y.partner_of(wave);
                for (int j = wave;; j = partner) {
                    add_row(modes.x.n, spot.y[static_cast<std::size_t>(j)], spot.x.data(), c, s, state.a.row(j),
                            state.b.row(j));
                    if (j == partner) break;
                }
            }
        }
    }
    state.a.row(0)[0] = level;
}

}  // namespace

void add_drops(const AiryModes& modes, std::span<const Drop> drops, AiryState& state) {
    std::vector<SpotModes> spots;
    for (const Drop& drop : drops) spots.emplace_back(drop, modes, drop.time_s - state.start_s);
    add_spots(modes, spots, state);
}

void add_disturbances(const AiryModes& modes, std::span<const Disturbance> disturbances, double time_s,
                      AiryState& state) {
    std::vector<SpotModes> spots;
    for (const Disturbance& d : disturbances)
        std::visit([&](const auto& spot) { spots.emplace_back(spot, modes, time_s - state.start_s); }, d);
    add_spots(modes, spots, state);
}

ForcedModes::ForcedModes(const Wavemaker& maker, const Grid& grid, const AiryModes& modes, PlaneTransform& transform)
    : start_s_(maker.start_s), full_s_(maker.start_s + maker.ramp_periods * maker.period_s) {
    const double omega = 2 * pi / maker.period_s, phase = maker.phase_deg * pi / 180;
    steady_ = {{1, omega, phase}};
    if (full_s_ > start_s_) {
        // (1 - cos(r t)) / 2 cos(W t + phase), r the ramp's frequency.
        const double r = pi / (full_s_ - start_s_);
        ramp_ = {{0.5, omega, phase}, {-0.25, omega + r, phase}, {-0.25, omega - r, phase}};
    }
    const double k = airy_wave_number(omega, modes.water);
    const Field<double> shape =
        inflow_shape(carried_on(maker, grid), modes.tank, k, airy_group_velocity(k, modes.water));
    Field<float> plane = transform.make_plane();
    for (int j = 0; j < shape.ny(); ++j) std::copy_n(shape.row(j), shape.nx(), plane.row(j));
    transform.to_slots(plane);
    plane.row(0)[0] = 0;
    float largest = 0;
    for (const float value : plane.values()) largest = std::max(largest, std::abs(value));
    for (int j = 0; j < modes.y.n; ++j)
        for (int i = 0; i < modes.x.n; ++i)
            if (const float value = plane.row(j)[i]; std::abs(value) > 1e-6f * largest)
                modes_.push_back(
                    {static_cast<std::size_t>(j) * static_cast<std::size_t>(modes.x.n) + static_cast<std::size_t>(i),
                     value, modes.omega.row(modes.y.wave_of(j))[modes.x.wave_of(i)]});
}

void ForcedModes::add(double from_s, double to_s, AiryState& state) const {
    add_tones(ramp_, std::max(from_s, start_s_), std::min(to_s, full_s_), state);
    add_tones(steady_, std::max(from_s, full_s_), to_s, state);
}

void ForcedModes::add_tones(std::span<const Tone> tones, double from_s, double to_s, AiryState& state) const {
    if (!(from_s < to_s)) return;
    const double middle = 0.5 * (from_s + to_s), half = 0.5 * (to_s - from_s);
    const auto count = static_cast<std::ptrdiff_t>(modes_.size());
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t m = 0; m < count; ++m) {
        const Mode& mode = modes_[static_cast<std::size_t>(m)];
        // The integral of tone(t) exp(i w (t - start)) over the interval.
        std::complex<double> integral = 0;
        for (const Tone& tone : tones) {
            const std::complex<double> at_middle = std::polar(1.0, tone.omega * (middle - start_s_) + tone.phase);
            integral += tone.amplitude * half *
                        (at_middle * sinc((mode.omega + tone.omega) * half) +
                         std::conj(at_middle) * sinc((mode.omega - tone.omega) * half));
        }
        integral *= mode.inflow_m_s * std::polar(1.0, mode.omega * (middle - state.start_s));
        state.a.data()[mode.slot] += integral.real();
        state.b.data()[mode.slot] += integral.imag();
    }
}

}  // namespace waterlight
