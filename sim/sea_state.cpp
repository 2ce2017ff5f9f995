#include "sim/sea_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "sim/airy_dispersion.hpp"
#include "sim/random.hpp"

namespace waterlight {

namespace {

constexpr double pi = std::numbers::pi;

/// A rectangle of wave-number space, rad/m.
struct WaveCell {
    double kx, ky;  ///< centre
    double width, height;

    double area() const { return width * height; }
};

/// E(kx, ky) in m^4: variance per area of wave-number space.
double density(const Sea& sea, const Water& water, double kx, double ky) {
    const double k = std::hypot(kx, ky);
    if (k <= 0) return 0;
    const double f = airy_omega(k, water) / (2 * pi);
    if (f < sea.spectrum.f_min_hz || f > sea.spectrum.f_max_hz) return 0;
    return sea.spectrum.density(f, std::atan2(ky, kx)) * airy_group_velocity(k, water) / (2 * pi * k);
}

/// Midpoint rule on parts x parts equal parts.
double midpoints(const Sea& sea, const Water& water, const WaveCell& cell, int parts) {
    double sum = 0;
    for (int j = 0; j < parts; ++j)
        for (int i = 0; i < parts; ++i)
            sum += density(sea, water, cell.kx + ((i + 0.5) / parts - 0.5) * cell.width,
                           cell.ky + ((j + 0.5) / parts - 0.5) * cell.height);
    return sum * cell.area() / (parts * parts);
}

/// Variance (m^2) in the cell: far from the origin, where the spectrum is smooth across it, few samples; near it, parts
/// are divided until they agree with their own quarters.
double variance_in(const Sea& sea, const Water& water, const WaveCell& cell, int depth = 0) {
    const double cells_from_origin = std::hypot(cell.kx / cell.width, cell.ky / cell.height);
    if (depth == 0 && cells_from_origin > 100) return midpoints(sea, water, cell, 1);
    if (depth == 0 && cells_from_origin > 24) return midpoints(sea, water, cell, 2);
    const double coarse = midpoints(sea, water, cell, 3), fine = midpoints(sea, water, cell, 6);
    const double settled = std::max(1e-3 * std::abs(fine), 1e-8 * sea.spectrum.variance_m2);
    if ((std::abs(fine - coarse) <= settled && depth > 0) || depth >= 7) return fine;
    double sum = 0;
    for (const double sx : {-0.25, 0.25})
        for (const double sy : {-0.25, 0.25})
            sum += variance_in(sea, water,
                               {cell.kx + sx * cell.width, cell.ky + sy * cell.height, cell.width / 2, cell.height / 2},
                               depth + 1);
    return sum;
}

/// Phase of wave vector (i, j), the same on every grid.
double phase_of(std::uint64_t seed, int i, int j) {
    const auto stream =
        (static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)) << 32) | static_cast<std::uint32_t>(j);
    return 2 * pi * RandomStream(seed, stream).uniform();
}

/// Adds cos(k.x + phase - w t), x from the corner of the grid; i and j are the signed numbers of waves along the axes.
struct PlaneWave {
    int i, j;
    double amplitude, phase;
};

void add_wave(const AiryModes& modes, const PlaneWave& wave, AiryState& state) {
    const int p = std::abs(wave.i), q = std::abs(wave.j);
    const double kx = modes.x.wave_number(p), ky = modes.y.wave_number(q);
    const double sign_x = wave.i < 0 ? -1 : 1, sign_y = wave.j < 0 ? -1 : 1;
    const double phase = wave.phase + sign_x * kx * (modes.x.origin_m() - modes.x.corner_m) +
                         sign_y * ky * (modes.y.origin_m() - modes.y.corner_m);
    const double c = wave.amplitude * std::cos(phase), s = wave.amplitude * std::sin(phase);
    const int px = modes.x.partner_of(p), qy = modes.y.partner_of(q);
    const auto add = [&](int slot_x, int slot_y, double a, double b) {
        state.a.row(slot_y)[slot_x] += a;
        state.b.row(slot_y)[slot_x] += b;
    };
    // cos(X + Y + phase) and its quadrature sin(X + Y + phase) in products of cosines and sines of X and Y.
    add(p, q, c, s);
    if (px != p && qy != q) add(px, qy, -sign_x * sign_y * c, -sign_x * sign_y * s);
    if (px != p) add(px, q, -sign_x * s, sign_x * c);
    if (qy != q) add(p, qy, -sign_y * s, sign_y * c);
}

}  // namespace

SeaCoverage add_sea(const Sea& sea, const AiryModes& modes, AiryState& state) {
    const double dkx = modes.x.wave_step(), dky = modes.y.wave_step();
    const int highest_i = (modes.x.n - 1) / 2, highest_j = (modes.y.n - 1) / 2;
    std::vector<double> carried(static_cast<std::size_t>(highest_j) + 1);
    // Rows j and -j share their slots with no others: one thread does both.
#pragma omp parallel for schedule(dynamic)
    for (int row = 0; row <= highest_j; ++row) {
        double sum = 0;
        for (int j : {row, -row}) {
            for (int i = -highest_i; i <= highest_i; ++i) {
                if (i == 0 && j == 0) continue;
                const double variance = variance_in(sea, modes.water, {i * dkx, j * dky, dkx, dky});
                sum += variance;
                add_wave(modes, {i, j, std::sqrt(2 * variance), phase_of(sea.seed, i, j)}, state);
            }
            if (row == 0) break;
        }
        carried[static_cast<std::size_t>(row)] = sum;
    }
    SeaCoverage coverage;
    coverage.variance_m2 = sea.spectrum.variance_m2;
    double sum = 0;
    for (const double row : carried) sum += row;
    const double longer = variance_in(sea, modes.water, {0, 0, dkx, dky});
    coverage.longer_fraction = longer / coverage.variance_m2;
    coverage.shorter_fraction = std::max(0.0, 1 - (sum + longer) / coverage.variance_m2);
    return coverage;
}

}  // namespace waterlight
