#include "sim/airy_margin.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/airy_dispersion.hpp"
#include "sim/fft_lines.hpp"

namespace waterlight {

namespace {

/// Lines a and b of one place: the slots of the waves towards + and of those towards -.
struct Directions {
    float plus, minus;
};

/// Cosine slots from e's cosine and q's sine.
Directions split_cosine(float e_cosine, float q_sine) {
    return {0.5f * (e_cosine + q_sine), 0.5f * (e_cosine - q_sine)};
}

/// Sine slots from e's sine and q's cosine.
Directions split_sine(float e_sine, float q_cosine) { return {0.5f * (e_sine - q_cosine), 0.5f * (e_sine + q_cosine)}; }

/// Calls alone(m) for each slot without a partner, and pair(m, n - m) for the others.
template <class Alone, class Pair>
void visit_slots(int n, Alone alone, Pair pair) {
    alone(0);
    if (n % 2 == 0) alone(n / 2);
#pragma GCC ivdep
    for (int m = 1; m < (n + 1) / 2; ++m) pair(m, n - m);
}

/// One line of e and q to the parts it is the sum of. A slot without a partner serves as its own.
void split_row(int n, const float* __restrict e, const float* __restrict q, float* __restrict plus,
               float* __restrict minus) {
    const auto put = [=](int m, Directions d) { plus[m] = d.plus, minus[m] = d.minus; };
    visit_slots(
        n, [=](int m) { put(m, split_cosine(e[m], q[m])); },
        [=](int m, int partner) {
            put(m, split_cosine(e[m], q[partner]));
            put(partner, split_sine(e[partner], q[m]));
        });
}

void join_row(int n, const float* __restrict plus, const float* __restrict minus, float* __restrict e,
              float* __restrict q) {
    visit_slots(
        n, [=](int m) { e[m] = plus[m] + minus[m], q[m] = plus[m] - minus[m]; },
        [=](int m, int partner) {
            e[m] = plus[m] + minus[m];
            q[partner] = plus[m] - minus[m];
            e[partner] = plus[partner] + minus[partner];
            q[m] = minus[partner] - plus[partner];
        });
}

constexpr int columns_per_tile = tile_lines / 2;

/// The same for a tile of columns; lines 2l and 2l + 1 of `tile` are the parts of column l.
void split_columns(const Field<float>& e, const Field<float>& q, int i, int width, Field<float>& tile) {
    const auto cosines = [&](int m, int q_row) {
        const float *from_e = e.row(m) + i, *from_q = q.row(q_row) + i;
        for (int l = 0; l < width; ++l) {
            const Directions d = split_cosine(from_e[l], from_q[l]);
            tile.row(m)[2 * l] = d.plus, tile.row(m)[2 * l + 1] = d.minus;
        }
    };
    const auto sines = [&](int m, int q_row) {
        const float *from_e = e.row(m) + i, *from_q = q.row(q_row) + i;
        for (int l = 0; l < width; ++l) {
            const Directions d = split_sine(from_e[l], from_q[l]);
            tile.row(m)[2 * l] = d.plus, tile.row(m)[2 * l + 1] = d.minus;
        }
    };
    visit_slots(
        tile.ny(), [&](int m) { cosines(m, m); }, [&](int m, int partner) { cosines(m, partner), sines(partner, m); });
}

void join_columns(const Field<float>& tile, int i, int width, Field<float>& e, Field<float>& q) {
    const auto put = [&](int m, int q_row, float q_sign) {
        float *to_e = e.row(m) + i, *to_q = q.row(q_row) + i;
        const float* from = tile.row(m);
        for (int l = 0; l < width; ++l) {
            to_e[l] = from[2 * l] + from[2 * l + 1];
            to_q[l] = q_sign * (from[2 * l] - from[2 * l + 1]);
        }
    };
    visit_slots(
        tile.ny(), [&](int m) { put(m, m, 1); }, [&](int m, int partner) { put(m, partner, 1), put(partner, m, -1); });
}

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
    margin.step_s = 0.5 / margin.sigma_max;
    return margin;
}

double transmitted_fraction(const AbsorbingMargin& margin, double k, const Water& water) {
    return std::exp(-margin.sigma_max * margin.width_m / airy_group_velocity(k, water));
}

DirectionalDamping::DirectionalDamping(const AxisBasis& axis, const AbsorbingMargin& margin)
    : axis_(axis), row_(axis.n, 1), columns_(axis.n, columns_per_tile) {
    for (int i = 0; i < axis.n; ++i) rates_.push_back(margin.rate(i, axis.n));
}

std::vector<float> DirectionalDamping::factors(double step_s) const {
    std::vector<float> factors;
    for (const double rate : rates_) factors.push_back(static_cast<float>(std::exp(-rate * step_s)));
    return factors;
}

void DirectionalDamping::damp_rows(double step_s, int rows, Field<float>& e, Field<float>& q) const {
    const std::vector<float> factor = factors(step_s);
    const LinePacking packing(axis_, false);
    const int n = axis_.n;
#pragma omp parallel
    {
        Field<float> parts(n, 2), complex(2 * n, 1);
        float *plus = parts.row(0), *minus = parts.row(1), *z = complex.data();
#pragma omp for schedule(static)
        for (int j = 0; j < rows; ++j) {
            split_row(n, e.row(j), q.row(j), plus, minus);
            pack_rows(packing, plus, minus, z);
            row_.to_space(z);
            for (int i = 0; i < n; ++i) z[2 * i] *= factor[i], z[2 * i + 1] *= factor[i];
            row_.to_slots(z);
            unpack_slots(packing, z, plus, minus);
            join_row(n, plus, minus, e.row(j), q.row(j));
        }
    }
}

void DirectionalDamping::damp_columns(double step_s, int columns, Field<float>& e, Field<float>& q) const {
    const std::vector<float> factor = factors(step_s);
    const LinePacking packing(axis_, false);
    const int n = axis_.n;
#pragma omp parallel
    {
        Field<float> parts(tile_lines, n), complex(tile_lines, n);
#pragma omp for schedule(static)
        for (int i = 0; i < columns; i += columns_per_tile) {
            const int width = std::min(columns_per_tile, columns - i);
            split_columns(e, q, i, width, parts);
            pack_columns(packing, parts.data(), tile_lines, tile_lines, complex.data());
            columns_.to_space(complex.data());
            for (int j = 0; j < n; ++j)
                for (int l = 0; l < tile_lines; ++l) complex.row(j)[l] *= factor[j];
            columns_.to_slots(complex.data());
            unpack_column_slots(packing, complex.data(), parts.data(), tile_lines, tile_lines);
            join_columns(parts, i, width, e, q);
        }
    }
}

}  // namespace waterlight
