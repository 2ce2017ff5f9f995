#include "sim/airy_initial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "sim/error.hpp"

namespace waterlight {

namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;

/// Slots of cos(half_waves pi (x - corner) / length).
std::vector<double> standing_slots(int half_waves, Side side, const AxisBasis& axis, char name) {
    if (side == Side::absorbing)
        throw InputError(
            fmt::format("airy: a standing wave needs sides that are periodic or walls, but {} absorbs", name));
    if (half_waves < 0)
        throw InputError(
            fmt::format("airy: half_waves_{} of a standing wave is {}; it must be 0 or more", name, half_waves));
    if (side == Side::periodic && half_waves % 2 != 0)
        throw InputError(
            fmt::format("airy: half_waves_{} is {}; a periodic side takes even numbers only", name, half_waves));
    const int wave = side == Side::periodic ? half_waves / 2 : half_waves;
    const int highest = side == Side::periodic ? (axis.n - 1) / 2 : axis.n - 1;
    if (wave > highest)
        throw InputError(fmt::format("airy: half_waves_{} is {}, shorter than two cells; {} cells carry {} at most",
                                     name, half_waves, axis.n, side == Side::periodic ? 2 * highest : highest));
    std::vector<double> slots(static_cast<std::size_t>(axis.n));
    const double phase = axis.wave_number(wave) * (axis.origin_m() - axis.corner_m);
    slots[static_cast<std::size_t>(wave)] = std::cos(phase);
    if (const int partner = axis.partner_of(wave); partner != wave)
        slots[static_cast<std::size_t>(partner)] = -std::sin(phase);
    return slots;
}

/// 1 in the visible part, falling smoothly to 0 at the far end of the margins.
double fading(int i, const AxisBasis& axis, int margin_cells) {
    const int outside = std::max(margin_cells - i, i - (axis.n - 1 - margin_cells));
    if (outside <= 0) return 1;
    const double c = std::cos(0.5 * pi * (outside - 0.5) / margin_cells);
    return c * c;
}

/// Slots of exp(i k x), real and imaginary part, by direct sums over the cells in double.
std::vector<Complex> sine_slots(double k, const AxisBasis& axis, int margin_cells) {
    std::vector<Complex> slots(static_cast<std::size_t>(axis.n));
    const auto x_m = [&](int i) { return axis.corner_m + (i + 0.5) * axis.spacing_m; };
    std::vector<Complex> samples;
    for (int i = 0; i < axis.n; ++i) samples.push_back(fading(i, axis, margin_cells) * std::polar(1.0, k * x_m(i)));
    for (int wave = 0; wave < axis.distinct(); ++wave) {
        const int partner = axis.partner_of(wave);
        // Over the cells the basis functions are cosines and sines of a fixed angle: a rotation gives the next.
        const Complex turn = std::polar(1.0, axis.wave_number(wave) * axis.spacing_m);
        Complex basis = std::polar(1.0, axis.wave_number(wave) * (x_m(0) - axis.origin_m()));
        Complex cosine = 0, sine = 0;
        for (const Complex& sample : samples) {
            cosine += sample * basis.real();
            sine += sample * basis.imag();
            basis *= turn;
        }
        slots[static_cast<std::size_t>(wave)] = cosine / (axis.n * axis.mean_square(wave));
        if (partner != wave) slots[static_cast<std::size_t>(partner)] = sine / (axis.n * axis.mean_square(partner));
    }
    return slots;
}

void require_fit(double k, Side side, const AxisBasis& axis, char name) {
    if (std::abs(k) * axis.spacing_m >= pi)
        throw InputError(
            fmt::format("airy: a sine is shorter than two cells along {} ({} m each)", name, axis.spacing_m));
    const double waves = k * axis.length_m() / (2 * pi);
    if (side == Side::periodic && std::abs(waves - std::round(waves)) > 1e-6)
        throw InputError(
            fmt::format("airy: a sine makes {:.6g} waves along the periodic side {}; only whole numbers fit, the "
                        "nearest is {:.0f} (choose wavelength and direction to suit)",
                        waves, name, std::round(waves)));
}

}  // namespace

void add_standing(const StandingWave& wave, const Boundary& boundary, const AiryModes& modes, AiryState& state) {
    const auto x = standing_slots(wave.half_waves_x, boundary.x, modes.x, 'x');
    const auto y = standing_slots(wave.half_waves_y, boundary.y, modes.y, 'y');
    for (int j = 0; j < modes.y.n; ++j)
        for (int i = 0; i < modes.x.n; ++i)
            state.a.row(j)[i] += wave.amplitude_m * x[static_cast<std::size_t>(i)] * y[static_cast<std::size_t>(j)];
}

void add_sine(const Sine& sine, const Boundary& boundary, const AiryModes& modes, AiryState& state) {
    if (sine.frozen) throw InputError("airy: waves move; a frozen sine needs the model \"prescribed\"");
    if (!(sine.wavelength_m > 0)) throw InputError("airy: the wavelength of a sine must be above 0");
    const glm::dvec2 k = wave_vector(sine);
    require_fit(k.x, boundary.x, modes.x, 'x');
    require_fit(k.y, boundary.y, modes.y, 'y');
    const auto x = sine_slots(k.x, modes.x, modes.visible.i0);
    const auto y = sine_slots(k.y, modes.y, modes.visible.j0);
    // elevation a cos(k.x + phase - w t), quadrature a sin(k.x + phase - w t).
    const Complex amplitude = std::polar(sine.amplitude_m, sine.phase_deg * pi / 180);
    for (int j = 0; j < modes.y.n; ++j) {
        for (int i = 0; i < modes.x.n; ++i) {
            const Complex slot = amplitude * x[static_cast<std::size_t>(i)] * y[static_cast<std::size_t>(j)];
            state.a.row(j)[i] += slot.real();
            state.b.row(j)[i] += slot.imag();
        }
    }
    state.b.row(0)[0] = 0;
}

}  // namespace waterlight
