#include "sim/fft_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace waterlight {

namespace {

/// One element of each line of a tile.
struct TileRow {
    float v[tile_lines];
};

TileRow load(const float* from, int width) {
    TileRow row{};
    if (width == tile_lines)
        std::copy_n(from, tile_lines, row.v);
    else
        std::copy_n(from, width, row.v);
    return row;
}

void store(const TileRow& row, float* to, int width) {
    if (width == tile_lines)
        std::copy_n(row.v, tile_lines, to);
    else
        std::copy_n(row.v, width, to);
}

TileRow weighted(float p, const TileRow& u, float q, const TileRow& w) {
    TileRow sum;
    for (int l = 0; l < tile_lines; ++l) sum.v[l] = p * u.v[l] + q * w.v[l];
    return sum;
}

/// re + i im of the pairs: lines 2l and 2l + 1 are real and imaginary part of one complex line; sign -1 conjugates
/// first.
TileRow joined(const TileRow& re, const TileRow& im, float sign) {
    TileRow z;
    for (int l = 0; l < tile_lines; l += 2) {
        z.v[l] = re.v[l] - sign * im.v[l + 1];
        z.v[l + 1] = re.v[l + 1] + sign * im.v[l];
    }
    return z;
}

/// The inverse of `joined`: from Z_m and Z_{n-m} the real and imaginary parts of both lines.
void separate(const TileRow& z, const TileRow& mirror, TileRow& re, TileRow& im) {
    for (int l = 0; l < tile_lines; l += 2) {
        re.v[l] = 0.5f * (z.v[l] + mirror.v[l]);
        re.v[l + 1] = 0.5f * (z.v[l + 1] + mirror.v[l + 1]);
        im.v[l] = 0.5f * (z.v[l + 1] - mirror.v[l + 1]);
        im.v[l + 1] = 0.5f * (mirror.v[l] - z.v[l]);
    }
}

}  // namespace

LinePacking::LinePacking(const AxisBasis& axis, bool derivative)
    : n(axis.n), folded(axis.kind == AxisBasis::Kind::cosine), odd_sign(derivative ? -1.0f : 1.0f) {
    const std::size_t half = static_cast<std::size_t>((n + 1) / 2);
    for (auto* table : {&re_u, &re_w, &im_u, &im_w}) table->resize(half);
    const double k_middle = axis.wave_number(n / 2);
    first = derivative ? 0.0f : 1.0f;
    middle = static_cast<float>((derivative ? (folded ? -k_middle : 0) : 1) * (folded ? std::numbers::sqrt2 / 2 : 1));
    for (int m = 1; m < (n + 1) / 2; ++m) {
        const double angle = folded ? std::numbers::pi * m / (2.0 * n) : 0;
        const double p = 0.5 * std::cos(angle), q = 0.5 * std::sin(angle);
        const double k = axis.wave_number(m);
        const auto i = static_cast<std::size_t>(m);
        // (p + i q) (alpha - i beta): alpha = u and beta = w for values, alpha = ka w and beta = kb u for derivatives.
        const double ka = folded ? -axis.wave_number(n - m) : k, kb = -k;
        re_u[i] = static_cast<float>(derivative ? q * kb : p);
        re_w[i] = static_cast<float>(derivative ? p * ka : q);
        im_u[i] = static_cast<float>(derivative ? -p * kb : q);
        im_w[i] = static_cast<float>(derivative ? q * ka : -p);
    }
}

int LinePacking::sample_of(int j) const {
    if (!folded) return j;
    return 2 * j < n ? 2 * j : 2 * (n - 1 - j) + 1;
}

void pack_rows(const LinePacking& packing, const float* __restrict a, const float* __restrict b, float* __restrict z) {
    const int n = packing.n;
    const float* __restrict ru = packing.re_u.data();
    const float* __restrict rw = packing.re_w.data();
    const float* __restrict iu = packing.im_u.data();
    const float* __restrict iw = packing.im_w.data();
    z[0] = packing.first * a[0];
    z[1] = packing.first * b[0];
    if (n % 2 == 0) {
        z[n] = packing.middle * a[n / 2];
        z[n + 1] = packing.middle * b[n / 2];
    }
#pragma GCC ivdep
    for (int m = 1; m < (n + 1) / 2; ++m) {
        const float a_re = ru[m] * a[m] + rw[m] * a[n - m], a_im = iu[m] * a[m] + iw[m] * a[n - m];
        const float b_re = ru[m] * b[m] + rw[m] * b[n - m], b_im = iu[m] * b[m] + iw[m] * b[n - m];
        z[2 * m] = a_re - b_im;
        z[2 * m + 1] = b_re + a_im;
        z[2 * (n - m)] = a_re + b_im;
        z[2 * (n - m) + 1] = b_re - a_im;
    }
}

void unpack_rows(const LinePacking& packing, const float* __restrict z, float* __restrict a, float* __restrict b) {
    const int n = packing.n;
    const float sign = packing.odd_sign;
    if (!packing.folded) {
#pragma GCC ivdep
        for (int j = 0; j < n; ++j) {
            a[j] = z[2 * j];
            b[j] = z[2 * j + 1];
        }
        return;
    }
#pragma GCC ivdep
    for (int j = 0; j < n / 2; ++j) {
        a[2 * j] = z[2 * j];
        b[2 * j] = z[2 * j + 1];
        a[2 * j + 1] = sign * z[2 * (n - 1 - j)];
        b[2 * j + 1] = sign * z[2 * (n - 1 - j) + 1];
    }
    if (n % 2 == 1) {
        a[n - 1] = z[n - 1];
        b[n - 1] = z[n];
    }
}

void pack_samples(const LinePacking& packing, const float* a, const float* b, float* z) {
    for (int j = 0; j < packing.n; ++j) {
        const int sample = packing.sample_of(j);
        z[2 * j] = a[sample];
        z[2 * j + 1] = b[sample];
    }
}

void unpack_slots(const LinePacking& packing, const float* __restrict z, float* __restrict a, float* __restrict b) {
    const int n = packing.n;
    const float mean = 1.0f / static_cast<float>(n);
    a[0] = mean * z[0];
    b[0] = mean * z[1];
    if (n % 2 == 0) {
        a[n / 2] = mean / packing.middle * z[n];
        b[n / 2] = mean / packing.middle * z[n + 1];
    }
    const float* __restrict p = packing.re_u.data();
    const float* __restrict q = packing.re_w.data();
#pragma GCC ivdep
    for (int m = 1; m < (n + 1) / 2; ++m) {
        const float a_re = z[2 * m] + z[2 * (n - m)], a_im = z[2 * m + 1] - z[2 * (n - m) + 1];
        const float b_re = z[2 * m + 1] + z[2 * (n - m) + 1], b_im = z[2 * (n - m)] - z[2 * m];
        a[m] = 2 * mean * (p[m] * a_re + q[m] * a_im);
        b[m] = 2 * mean * (p[m] * b_re + q[m] * b_im);
        a[n - m] = 2 * mean * (q[m] * a_re - p[m] * a_im);
        b[n - m] = 2 * mean * (q[m] * b_re - p[m] * b_im);
    }
}

void pack_columns(const LinePacking& packing, const float* plane, int pitch, int width, float* tile) {
    const int n = packing.n;
    const auto element = [&](int m) { return load(plane + static_cast<std::ptrdiff_t>(m) * pitch, width); };
    const auto put = [&](int m, const TileRow& row) { store(row, tile + m * tile_lines, tile_lines); };
    put(0, weighted(packing.first, element(0), 0, {}));
    if (n % 2 == 0) put(n / 2, weighted(packing.middle, element(n / 2), 0, {}));
    for (int m = 1; m < (n + 1) / 2; ++m) {
        const auto i = static_cast<std::size_t>(m);
        const TileRow u = element(m), w = element(n - m);
        const TileRow re = weighted(packing.re_u[i], u, packing.re_w[i], w);
        const TileRow im = weighted(packing.im_u[i], u, packing.im_w[i], w);
        put(m, joined(re, im, 1));
        put(n - m, joined(re, im, -1));
    }
}

void unpack_columns(const LinePacking& packing, const float* tile, float* plane, int pitch, int width) {
    for (int j = 0; j < packing.n; ++j) {
        const TileRow row = weighted(packing.sign_of(j), load(tile + j * tile_lines, tile_lines), 0, {});
        store(row, plane + static_cast<std::ptrdiff_t>(packing.sample_of(j)) * pitch, width);
    }
}

void pack_column_samples(const LinePacking& packing, const float* plane, int pitch, int width, float* tile) {
    for (int j = 0; j < packing.n; ++j) {
        const TileRow row = load(plane + static_cast<std::ptrdiff_t>(packing.sample_of(j)) * pitch, width);
        store(row, tile + j * tile_lines, tile_lines);
    }
}

void unpack_column_slots(const LinePacking& packing, const float* tile, float* plane, int pitch, int width) {
    const int n = packing.n;
    const float mean = 1.0f / static_cast<float>(n);
    const auto element = [&](int m) { return load(tile + m * tile_lines, tile_lines); };
    const auto put = [&](int m, const TileRow& row) {
        store(row, plane + static_cast<std::ptrdiff_t>(m) * pitch, width);
    };
    put(0, weighted(mean, element(0), 0, {}));
    if (n % 2 == 0) put(n / 2, weighted(mean / packing.middle, element(n / 2), 0, {}));
    for (int m = 1; m < (n + 1) / 2; ++m) {
        const auto i = static_cast<std::size_t>(m);
        TileRow re, im;
        separate(element(m), element(n - m), re, im);
        const float p = 4 * mean * packing.re_u[i], q = 4 * mean * packing.re_w[i];
        put(m, weighted(p, re, q, im));
        put(n - m, weighted(q, re, -p, im));
    }
}

}  // namespace waterlight
