#include "caustics/quads_share.hpp"

#include <omp.h>

#include <cmath>

#include "caustics/floor_ring.hpp"
#include "caustics/floor_row_ledger.hpp"
#include "caustics/polygon.hpp"

namespace waterlight {

namespace {

constexpr float least_area = 0.02F;  // of a quad, pixels: below it single precision has too few digits for its shares

/// Corners of quad i of a row, from the lower left corner of its base pixel.
struct QuadCorners {
    const float *x_low, *y_low, *x_high, *y_high;

    QuadCorners(const LandedSamples& corners, int j)
        : x_low(corners.x.row(j)),
          y_low(corners.y.row(j)),
          x_high(corners.x.row(j + 1)),
          y_high(corners.y.row(j + 1)) {}

    std::array<glm::dvec2, 4> at(int i) const {
        return {{{x_low[i], y_low[i]},
                 {1 + static_cast<double>(x_low[i + 1]), y_low[i + 1]},
                 {1 + static_cast<double>(x_high[i + 1]), 1 + static_cast<double>(y_high[i + 1])},
                 {x_high[i], 1 + static_cast<double>(y_high[i])}}};
    }
};

/// Pixels that may be of interest: [low, high).
struct PixelRange {
    glm::ivec2 low, high;
};

/// Adds up the shares in a range.
struct SharesWithin {
    PixelRange range;
    double sum = 0;
    void operator()(int column, int row, double share) {
        const bool in = column >= range.low.x && column < range.high.x && row >= range.low.y && row < range.high.y;
        if (in) sum += share;
    }
};

/// Shares out one triangle.
template <class Take>
void share_triangle(const std::array<glm::dvec2, 3>& t, const PixelRange& range, CellShares& exact, Take&& take) {
    const glm::dvec2 low = glm::min(t[0], glm::min(t[1], t[2])), high = glm::max(t[0], glm::max(t[1], t[2]));
    const glm::dvec2 span = high - low;
    constexpr double large = 64;  // pixels: from here on only those of interest are looked at
    if (span.x < large && span.y < large && std::abs(low.x) < 1e9 && std::abs(low.y) < 1e9) return exact.share(t, take);
    const double area = waterlight::area(Polygon{{t[0], t[1], t[2]}, 3});
    rasterise(t, range.low, range.high,
              [&](int column, int row, double overlap) { take(column, row, overlap / std::abs(area)); });
}

double twice_area(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Shares out one quad of any shape. Of its two triangles each has the part of its area where they lie beside each
/// other, half where one is folded over the other.
template <class Take>
void share_quad(const std::array<glm::dvec2, 4>& q, const PixelRange& range, CellShares& exact, Take&& take) {
    const double one = twice_area(q[0], q[1], q[2]), two = twice_area(q[0], q[2], q[3]);
    const double part = one * two > 0 ? one / (one + two) : 0.5;
    share_triangle({q[0], q[1], q[2]}, range, exact, [&](int i, int j, double s) { take(i, j, part * s); });
    share_triangle({q[0], q[2], q[3]}, range, exact, [&](int i, int j, double s) { take(i, j, (1 - part) * s); });
}

}  // namespace

class QuadSharer::Band : public ChannelBand {
  public:
    Band(const FloorFrame& frame, const SurfaceRows& surface, const LandedQuads& landed, Scratch& scratch,
         std::vector<RowLedger>& ledger, int begin, int end)
        : ChannelBand(frame, scratch.channels, begin, end),
          surface_(surface),
          landed_(landed),
          s_(scratch),
          ledger_(ledger) {
        s_.pixel.resize(QuadBatch::size);
        s_.shares.resize(4 * 4 * QuadBatch::size);
        s_.counted.resize(frame.columns.count);
    }

    /// Adds row j of the quads, and settles its ledger; `apart`: none of it can touch the band.
    void add(const LandedSamples& corners, int j, bool apart) {
        const int base = std::clamp(frame_.rows.first + j, 0, frame_.map_height - 1);
        if (base >= begin_ && base < end_) account(corners, j);
        if (apart) return;
        const QuadCorners quads(corners, j);
        const float* power = corners.power.row(j);
        for (int begin = 0; begin < frame_.columns.count; begin += QuadBatch::size) {
            const Span span{begin, std::min(begin + QuadBatch::size, frame_.columns.count)};
            share_small(quads, power, j, span);
            ring_.add(span.end - span.begin, s_.pixel.data(), s_.shares.data());
            for (int i = span.begin; i < span.end; ++i)
                if (s_.left_over[i - span.begin]) add_left_over(quads.at(i), power[i], i, j);
            add_nine();
        }
        for (const CutPiece& piece : landed_.pieces[j])
            share_triangle(piece.pixel, band_range(), s_.exact,
                           [&](int column, int row, double share) { put(column, row, share * piece.power); });
    }

  private:
    PixelRange band_range() const { return {{0, begin_}, {frame_.map_width, end_}}; }
    PixelRange map_range() const { return {{0, 0}, {frame_.map_width, frame_.map_height}}; }

    /// Shares out those quads of a part of a row that are within two by two pixels; the others are left over, and have
    /// no shares.
    void share_small(const QuadCorners& quads, const float* __restrict power, int j, Span span) {
        const float* __restrict x_low = quads.x_low + span.begin;
        const float* __restrict y_low = quads.y_low + span.begin;
        const float* __restrict x_high = quads.x_high + span.begin;
        const float* __restrict y_high = quads.y_high + span.begin;
        power += span.begin;
        const float bound_x = static_cast<float>(frame_.half_samples() + 4),
                    bound_y = static_cast<float>(frame_.half_channels() + 4);
        const ChannelRing ring = ring_;
        const int first_column = frame_.columns.first + span.begin + lead,
                  row_from_oldest = frame_.rows.first + j - ring.oldest();
        const int rows = this->rows(), count = span.end - span.begin;
        int* __restrict pixel = s_.pixel.data();
        float* __restrict shares = s_.shares.data();
        unsigned char* __restrict left_over = s_.left_over.data();
#pragma GCC ivdep
        for (int i = 0; i < count; ++i) {
            f32::real2 a(x_low[i], y_low[i]), b(1 + x_low[i + 1], y_low[i + 1]),
                c(1 + x_high[i + 1], 1 + y_high[i + 1]), d(x_high[i], 1 + y_high[i]);
            const float left = f32::min(f32::min(a.x, b.x), f32::min(c.x, d.x));
            const float right = f32::max(f32::max(a.x, b.x), f32::max(c.x, d.x));
            const float bottom = f32::min(f32::min(a.y, b.y), f32::min(c.y, d.y));
            const float top = f32::max(f32::max(a.y, b.y), f32::max(c.y, d.y));
            // Clamped so that any number, also one that is not, has an integer part.
            const float low_x = f32::floor(f32::clamp(left, -bound_x, bound_x));
            const float low_y = f32::floor(f32::clamp(bottom, -bound_y, bound_y));
            const float one = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
            const float two = (c.x - a.x) * (d.y - a.y) - (c.y - a.y) * (d.x - a.x);
            const float area = 0.5F * (one + two);
            const bool small = (one * two > 0) & (f32::abs(area) > least_area) & (right - low_x <= 2) &
                               (top - low_y <= 2) & (left >= low_x) & (bottom >= low_y);
            const auto moved = [&](f32::real2 p) { return f32::real2(p.x - low_x, p.y - low_y); };
            const f32::FourParts parts = f32::parts_in_four(moved(a), moved(b), moved(c), moved(d), area);
            left_over[i] = !small & !(power[i] == 0);
            pixel[i] =
                ring.pixel(first_column + i + static_cast<int>(low_x), row_from_oldest + static_cast<int>(low_y), rows);
            shares[4 * i] = small ? power[i] * parts.low_left : 0;
            shares[4 * i + 1] = small ? power[i] * parts.low_right : 0;
            shares[4 * i + 2] = small ? power[i] * parts.high_left : 0;
            shares[4 * i + 3] = small ? power[i] * parts.high_right : 0;
        }
    }

    /// A quad that is not within two by two pixels: put by for a batch of those within three by three, or shared.
    void add_left_over(const std::array<glm::dvec2, 4>& q, float power, int i, int j) {
        const glm::ivec2 base{frame_.columns.first + i, frame_.rows.first + j};
        const glm::dvec2 low = glm::min(glm::min(q[0], q[1]), glm::min(q[2], q[3]));
        const glm::dvec2 high = glm::max(glm::max(q[0], q[1]), glm::max(q[2], q[3]));
        // A sum keeps what is not a number, as the least and largest do not.
        const glm::dvec2 sum = glm::abs(low) + glm::abs(high) + glm::abs(q[0] + q[1] + q[2] + q[3]);
        if (!(sum.x + sum.y < 1e9))
            return put(base.x, base.y, power);  // not a number: it shows where it should have been
        // By the map, not by the band: where in its batch a quad is would show in the last digit.
        if (base.y + high.y < 0 || base.y + low.y > frame_.map_height || base.x + high.x < 0 ||
            base.x + low.x > frame_.map_width)
            return;
        const glm::dvec2 first = glm::floor(low);
        const double one = twice_area(q[0], q[1], q[2]), two = twice_area(q[0], q[2], q[3]);
        if (one * two > 0 && std::abs(one + two) > 4 * least_area && high.x - first.x <= 3 && high.y - first.y <= 3) {
            QuadBatch& b = s_.nine;
            const int at = b.count++;
            for (int k = 0; k < 4; ++k) {
                b.x[k][at] = static_cast<float>(q[k].x - first.x);
                b.y[k][at] = static_cast<float>(q[k].y - first.y);
            }
            b.area[at] = static_cast<float>(0.5 * (one + two));
            b.light[at] = power;
            b.column[at] = base.x + static_cast<int>(first.x);
            b.row[at] = base.y + static_cast<int>(first.y);
            return;
        }
        PixelRange range = band_range();
        range.low -= base;
        range.high -= base;
        share_quad(q, range, s_.exact,
                   [&](int column, int row, double share) { put(base.x + column, base.y + row, share * power); });
    }

    void add_nine() {
        s_.nine.share(s_.shares.data());
        for (int block = 0; block < 4; ++block)
            add_block(s_.nine, 2 * (block % 2), 2 * (block / 2), s_.shares.data() + 4 * block * QuadBatch::size);
        s_.nine.count = 0;
    }

    /// Adds shares of blocks of two by two pixels, this far from the batch's own.
    void add_block(const QuadBatch& batch, int right, int up, const float* shares) {
        int* __restrict pixel = s_.pixel.data();
        const int* __restrict column = batch.column.data();
        const int* __restrict row = batch.row.data();
        const ChannelRing ring = ring_;
        const int rows = this->rows(), above = up - ring.oldest(), beside = right + lead;
#pragma GCC ivdep
        for (int i = 0; i < batch.count; ++i) pixel[i] = ring.pixel(column[i] + beside, row[i] + above, rows);
        ring_.add(batch.count, pixel, shares);
    }

    void put(int column, int row, double light) {
        ring_.add(ring_.pixel(column + lead, row - ring_.oldest(), rows()), static_cast<float>(light));
    }

    /// Takes from the ledger of row j what does not land on the map.
    void account(const LandedSamples& corners, int j) {
        RowLedger& row = ledger_[j];
        const auto take = [&](double counted, double power, double on_map) {
            row.outside += counted * power * (1 - on_map);
            row.entered -= (1 - counted) * power * (1 - on_map);
        };
        const QuadCorners quads(corners, j);
        const float* power = corners.power.row(j);
        const int base = frame_.rows.first + j;
        const bool on_rows = base + std::floor(corners.lowest[j]) >= 0 &&
                             base + std::ceil(corners.highest[j]) <= static_cast<float>(frame_.map_height);
        const Span inner = on_rows ? inner_columns(frame_) : Span{0, 0};
        surface_.read_counted(j, s_.counted);
        for (const Span outer : {Span{0, inner.begin}, Span{inner.end, frame_.columns.count}})
            for (int i = outer.begin; i < outer.end; ++i)
                if (power[i] > 0) take(s_.counted[i], power[i], on_map(quads.at(i), {frame_.columns.first + i, base}));
        for (const CutPiece& piece : landed_.pieces[j]) take(piece.counted, piece.power, on_map(piece.pixel));
    }

    double on_map(const std::array<glm::dvec2, 4>& q, glm::ivec2 base) {
        PixelRange map = map_range();
        map.low -= base;
        map.high -= base;
        const glm::dvec2 low = glm::min(glm::min(q[0], q[1]), glm::min(q[2], q[3]));
        const glm::dvec2 high = glm::max(glm::max(q[0], q[1]), glm::max(q[2], q[3]));
        if (glm::all(glm::greaterThanEqual(low, glm::dvec2(map.low))) &&
            glm::all(glm::lessThanEqual(high, glm::dvec2(map.high))))
            return 1;
        if (glm::any(glm::lessThan(high, glm::dvec2(map.low))) || glm::any(glm::greaterThan(low, glm::dvec2(map.high))))
            return 0;
        SharesWithin within{map};
        share_quad(q, map, s_.exact, within);
        return within.sum;
    }

    double on_map(const std::array<glm::dvec2, 3>& piece) {
        SharesWithin within{map_range()};
        share_triangle(piece, within.range, s_.exact, within);
        return within.sum;
    }

    const SurfaceRows& surface_;
    const LandedQuads& landed_;
    Scratch& s_;
    std::vector<RowLedger>& ledger_;
};

double QuadSharer::collect(const FloorFrame& frame, const SurfaceRows& surface, const LandedQuads& landed,
                           Field<float>& map, std::vector<RowLedger>& ledger) {
    scratch_.resize(omp_get_max_threads());
    return collect_in_bands(frame, landed.corners, map, [&](int thread, int begin, int end) {
        return Band(frame, surface, landed, scratch_[thread], ledger, begin, end);
    });
}

}  // namespace waterlight
