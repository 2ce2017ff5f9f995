// Quads that overlap three by three pixels, many at a time: their shares by signed area under edges.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "caustics/kernels/cell_share.hpp"
#include "caustics/kernels/floor.hpp"

namespace waterlight {

struct QuadBatch {
    static constexpr int size = 256;  ///< so that a batch stays in the nearest cache
    using Row = std::array<float, size>;

    /// Corners in pixels from the lower left corner of the quad's block of pixels, in order round it; signed area.
    std::array<Row, 4> x, y;
    Row area, light;
    std::array<int, size> column, row;  ///< of the block's first pixel
    int count = 0;

    /// Shares in the pixels of the block, times the light, as four blocks of two by two: lower left, to its right, above
    /// it, and above to the right; each `size` apart. Those of a block in order of rows.
    void share(float* __restrict shares);

  private:
    /// The part of each quad that lies left of `right` and below `top`.
    void cover(float right, float top, Row& part) const {
        const f32::real2 scale(1 / right, 1 / top);
        const float area_scale = -right * top;
        const float* __restrict x0 = x[0].data();
        const float* __restrict x1 = x[1].data();
        const float* __restrict x2 = x[2].data();
        const float* __restrict x3 = x[3].data();
        const float* __restrict y0 = y[0].data();
        const float* __restrict y1 = y[1].data();
        const float* __restrict y2 = y[2].data();
        const float* __restrict y3 = y[3].data();
        const float* __restrict whole = area.data();
        float* __restrict to = part.data();
#pragma GCC ivdep
        for (int i = 0; i < count; ++i) {
            const f32::real2 a(x0[i] * scale.x, y0[i] * scale.y), b(x1[i] * scale.x, y1[i] * scale.y),
                c(x2[i] * scale.x, y2[i] * scale.y), d(x3[i] * scale.x, y3[i] * scale.y);
            const float right_of =
                f32::area_right_of(a, b) + f32::area_right_of(b, c) + f32::area_right_of(c, d) + f32::area_right_of(d, a);
            to[i] = area_scale * right_of / whole[i];
        }
    }

    std::array<Row, 8> part_;
};

inline void QuadBatch::share(float* __restrict shares) {
    for (int k = 0; k < 8; ++k) cover(static_cast<float>(1 + k % 3), static_cast<float>(1 + k / 3), part_[k]);
    for (int i = 0; i < count; ++i) {
        std::array<float, 9> cell{};
        float sum = 0;
        for (int k = 0; k < 9; ++k) {
            const auto below = [&](int c, int r) {
                return c < 0 || r < 0 ? 0.0F : (c + 3 * r == 8 ? 1.0F : part_[c + 3 * r][i]);
            };
            const int c = k % 3, r = k / 3;
            cell[k] = std::max(0.0F, below(c, r) - below(c - 1, r) - below(c, r - 1) + below(c - 1, r - 1));
            sum += cell[k];
        }
        const float each = light[i] / sum;
        for (int k = 0; k < 9; ++k) {
            const int c = k % 3, r = k / 3, block = c / 2 + 2 * (r / 2);
            shares[4 * (block * size + i) + c % 2 + 2 * (r % 2)] = each * cell[k];
        }
    }
}

}  // namespace waterlight
