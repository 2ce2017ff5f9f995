// Real transforms of pairs of lines through one complex FFT, for both kinds of axis.
//
// Two real lines a and b ride as real and imaginary part of one complex line (so that FFTW's SIMD code serves, which
// its real-to-real kinds lack). For Fourier slots X_m = (c_m - i s_m) / 2. For cosine slots (Makhoul 1980, IEEE Trans.
// ASSP 28(1), eqs. 8 to 13) X_m = exp(i pi m / 2n) (c_m - i c_{n-m}) / 2 gives the line in the order 0, 2, 4 ... 5,
// 3, 1. In both, X_m needs slots m and n - m only, and X_{n-m} = conj(X_m). Derivatives multiply slots by their wave
// numbers.
#pragma once

#include <vector>

#include "sim/fft_axis.hpp"

namespace waterlight {

/// What turns slots into the complex line: X_m = (re_u u + re_w w) + i (im_u u + im_w w), with u = slot m, w = slot n -
/// m.
struct LinePacking {
    LinePacking(const AxisBasis& axis, bool derivative);

    int n;
    bool folded;     ///< the line comes out in Makhoul's order
    float odd_sign;  ///< factor of the samples from the descending half: -1 for the derivative of cosines
    float first;     ///< X_0 = first * slot 0
    float middle;    ///< X_{n/2} = middle * slot n/2, where n is even
    std::vector<float> re_u, re_w, im_u, im_w;  ///< index m in [0, (n + 1) / 2)

    /// The sample that value j of the complex transform belongs to.
    int sample_of(int j) const;
    float sign_of(int j) const { return folded && 2 * j >= n ? odd_sign : 1.0f; }
};

/// Number of lines side by side in a tile: one cache line of floats.
inline constexpr int tile_lines = 16;

/// Slots of lines a and b (n values each) to the n complex values of `z`.
void pack_rows(const LinePacking& packing, const float* a, const float* b, float* z);
/// The transformed `z` to samples of a and b.
void unpack_rows(const LinePacking& packing, const float* z, float* a, float* b);
/// The inverses of the two above, for values (not derivatives); folded into the scale of 1 / n.
void pack_samples(const LinePacking& packing, const float* a, const float* b, float* z);
void unpack_slots(const LinePacking& packing, const float* z, float* a, float* b);

/// The same for a tile of tile_lines columns, `width` of them in use; element m of a column lies at plane[m * pitch].
void pack_columns(const LinePacking& packing, const float* plane, int pitch, int width, float* tile);
void unpack_columns(const LinePacking& packing, const float* tile, float* plane, int pitch, int width);
void pack_column_samples(const LinePacking& packing, const float* plane, int pitch, int width, float* tile);
void unpack_column_slots(const LinePacking& packing, const float* tile, float* plane, int pitch, int width);

}  // namespace waterlight
