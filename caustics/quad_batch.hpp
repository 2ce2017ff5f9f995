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

    /// Shares in the pixels of the block, times the light, as four blocks of two by two: lower left, to its right,
    /// above it, and above to the right; each `size` apart. Those of a block in order of rows.
    void share(float* __restrict shares);

  private:
    /// The parts of each quad that lie left of x = right, below y = top, and in the corner where both hold.
    void cover(float right, float top, Row& left, Row& bottom, Row& corner) const {
        const f32::real2 scale(1 / right, 1 / top);
        const float area_scale = right * top;
        const float* __restrict x0 = x[0].data();
        const float* __restrict x1 = x[1].data();
        const float* __restrict x2 = x[2].data();
        const float* __restrict x3 = x[3].data();
        const float* __restrict y0 = y[0].data();
        const float* __restrict y1 = y[1].data();
        const float* __restrict y2 = y[2].data();
        const float* __restrict y3 = y[3].data();
        const float* __restrict whole = area.data();
        float* __restrict to_left = left.data();
        float* __restrict to_bottom = bottom.data();
        float* __restrict to_corner = corner.data();
#pragma GCC ivdep
        for (int i = 0; i < count; ++i) {
            const f32::real2 a(x0[i] * scale.x, y0[i] * scale.y), b(x1[i] * scale.x, y1[i] * scale.y),
                c(x2[i] * scale.x, y2[i] * scale.y), d(x3[i] * scale.x, y3[i] * scale.y);
            const f32::CornerAreas parts = f32::corner_areas(a, b, c, d, area_scale / whole[i]);
            to_left[i] = parts.left;
            to_bottom[i] = parts.bottom;
            to_corner[i] = parts.corner;
        }
    }

    std::array<Row, 9> part_;
};

inline void QuadBatch::share(float* __restrict shares) {
    // part_[i + 3 j]: what lies left of x = i + 1 and below y = j + 1.
    Row no_left, no_bottom;
    cover(1, 1, part_[6], part_[2], part_[0]);
    cover(2, 2, part_[7], part_[5], part_[4]);
    cover(2, 1, no_left, no_bottom, part_[1]);
    cover(1, 2, no_left, no_bottom, part_[3]);
    std::fill_n(part_[8].data(), count, 1.0F);
    // From what lies left and below to the pixels, last to first.
    for (int k = 8; k >= 0; --k) {
        static constexpr Row none{};
        const bool first_column = k % 3 == 0, first_row = k < 3;
        const float* __restrict left = first_column ? none.data() : part_[k - 1].data();
        const float* __restrict below = first_row ? none.data() : part_[k - 3].data();
        const float* __restrict both = first_column || first_row ? none.data() : part_[k - 4].data();
        float* __restrict part = part_[k].data();
        for (int i = 0; i < count; ++i) part[i] = f32::max(0, part[i] - left[i] - below[i] + both[i]);
    }
    Row each{};
    for (const Row& part : part_)
        for (int i = 0; i < count; ++i) each[i] += part[i];
    for (int i = 0; i < count; ++i) each[i] = light[i] / each[i];
    for (int k = 0; k < 9; ++k) {
        const int c = k % 3, r = k / 3, block = c / 2 + 2 * (r / 2);
        float* __restrict to = shares + 4 * block * size + c % 2 + 2 * (r % 2);
        const float* __restrict part = part_[k].data();
        for (int i = 0; i < count; ++i) to[4 * i] = each[i] * part[i];
    }
}

}  // namespace waterlight
