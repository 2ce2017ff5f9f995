#include "sim/airy_margin.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "sim/airy_dispersion.hpp"
#include "sim/fft_lines.hpp"

namespace waterlight {

namespace {

constexpr int columns_per_tile = tile_lines / 2;

}  // namespace

double AbsorbingMargin::rate(int i, int n) const {
    const int outside = std::max(cells - i, i - (n - 1 - cells));
    if (outside <= 0) return 0;
    const double s = std::sin(0.5 * std::numbers::pi * (outside - 0.5) / cells);
    return sigma_max * s * s;
}

AbsorbingMargin make_margin(Side side, int n, double spacing_m, double margin_m, const Water& water) {
    AbsorbingMargin margin;
    if (side != Side::absorbing) return margin;
    const double width = margin_m > 0 ? margin_m : 0.25 * n * spacing_m;
    margin.cells = std::max(1, static_cast<int>(std::ceil(width / spacing_m)));
    if (n % 2 == 0)
        while (!is_fast_length(n + 2 * margin.cells)) ++margin.cells;
    margin.width_m = margin.cells * spacing_m;
    const double tank_m = (n + 2 * margin.cells) * spacing_m;
    const double fastest = airy_group_velocity(2 * std::numbers::pi / tank_m, water);
    margin.sigma_max = std::log(1e3) * fastest / margin.width_m;
    margin.turn_m = 0.5 * tank_m / (2 * std::numbers::pi);
    margin.step_s = 0.5 / margin.sigma_max;
    return margin;
}

double transmitted_fraction(const AbsorbingMargin& margin, double k, const Water& water) {
    return std::exp(-margin.sigma_max * margin.width_m / airy_group_velocity(k, water));
}

DirectionalDamping::DirectionalDamping(const AxisBasis& axis, const AbsorbingMargin& margin)
    : n_(axis.n), packing_(axis, false), row_(axis.n, 1), columns_(axis.n, columns_per_tile) {
    assert(axis.kind == AxisBasis::Kind::fourier);
    for (int i = 0; i < n_; ++i) rates_.push_back(margin.rate(i, n_));
    for (int m = 0; m < (n_ + 1) / 2; ++m) {
        const double angle = 0.5 * std::numbers::pi * std::tanh(axis.wave_number(m) * margin.turn_m);
        cosine_.push_back(static_cast<float>(std::cos(angle)));
        sine_.push_back(static_cast<float>(std::sin(angle)));
    }
}

std::vector<float> DirectionalDamping::factors(double step_s) const {
    std::vector<float> factors;
    for (const double rate : rates_) factors.push_back(static_cast<float>(std::exp(-rate * step_s)));
    return factors;
}

void DirectionalDamping::damp_rows(double step_s, int rows, Field<float>& e, Field<float>& q) const {
    const std::vector<float> factor = factors(step_s);
#pragma omp parallel
    {
        Field<float> turned(n_, 1), complex(2 * n_, 1);
        float *b = turned.data(), *z = complex.data();
#pragma omp for schedule(static)
        for (int j = 0; j < rows; ++j) {
            turn_row(1, q.row(j), b);
            pack_rows(packing_, e.row(j), b, z);
            row_.to_space(z);
            for (int i = 0; i < n_; ++i) z[2 * i] *= factor[i], z[2 * i + 1] *= factor[i];
            row_.to_slots(z);
            unpack_slots(packing_, z, e.row(j), b);
            turn_row(-1, b, q.row(j));
        }
    }
}

void DirectionalDamping::turn_row(float direction, const float* __restrict from, float* __restrict to) const {
    const float* __restrict c = cosine_.data(), * __restrict s = sine_.data();
    to[0] = from[0];
    if (n_ % 2 == 0) to[n_ / 2] = from[n_ / 2];
#pragma GCC ivdep
    for (int m = 1; m < (n_ + 1) / 2; ++m) {
        to[m] = c[m] * from[m] + direction * s[m] * from[n_ - m];
        to[n_ - m] = c[m] * from[n_ - m] - direction * s[m] * from[m];
    }
}

void DirectionalDamping::damp_columns(double step_s, int columns, Field<float>& e, Field<float>& q) const {
    const std::vector<float> factor = factors(step_s);
#pragma omp parallel
    {
        Field<float> slots(tile_lines, n_), complex(tile_lines, n_);
#pragma omp for schedule(static)
        for (int i = 0; i < columns; i += columns_per_tile) {
            const int width = std::min(columns_per_tile, columns - i);
            interleave(e, q, i, width, slots);
            pack_columns(packing_, slots.data(), tile_lines, tile_lines, complex.data());
            columns_.to_space(complex.data());
            for (int j = 0; j < n_; ++j)
                for (int l = 0; l < tile_lines; ++l) complex.row(j)[l] *= factor[j];
            columns_.to_slots(complex.data());
            unpack_column_slots(packing_, complex.data(), slots.data(), tile_lines, tile_lines);
            separate(slots, i, width, e, q);
        }
    }
}

void DirectionalDamping::interleave(const Field<float>& e, const Field<float>& q, int i, int width,
                                    Field<float>& slots) const {
    for (int j = 0; j < n_; ++j) {
        const int m = std::min(j, n_ - j), partner = j == 0 || 2 * j == n_ ? j : n_ - j;
        const float c = partner == j ? 1 : cosine_[m], s = partner == j ? 0 : j == m ? sine_[m] : -sine_[m];
        for (int l = 0; l < width; ++l) {
            slots.row(j)[2 * l] = e.row(j)[i + l];
            slots.row(j)[2 * l + 1] = c * q.row(j)[i + l] + s * q.row(partner)[i + l];
        }
    }
}

void DirectionalDamping::separate(const Field<float>& slots, int i, int width, Field<float>& e, Field<float>& q) const {
    for (int j = 0; j < n_; ++j) {
        const int m = std::min(j, n_ - j), partner = j == 0 || 2 * j == n_ ? j : n_ - j;
        const float c = partner == j ? 1 : cosine_[m], s = partner == j ? 0 : j == m ? -sine_[m] : sine_[m];
        for (int l = 0; l < width; ++l) {
            e.row(j)[i + l] = slots.row(j)[2 * l];
            q.row(j)[i + l] = c * slots.row(j)[2 * l + 1] + s * slots.row(partner)[2 * l + 1];
        }
    }
}

}  // namespace waterlight
