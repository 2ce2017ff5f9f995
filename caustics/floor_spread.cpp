#include <omp.h>

#include <algorithm>
#include <cmath>

#include "caustics/floor_parallelograms.hpp"
#include "caustics/floor_ring.hpp"

namespace waterlight {

namespace {

constexpr int chunk = 256;  // samples that pass 1 takes at a time, so that their shares stay in the nearest cache

/// Blocks of two by two pixels in which all parallelograms of a row are shared out at once; those that touch more
/// pixels are left over.
struct Blocks {
    bool wide;  ///< two beside each other
    int rows;   ///< on top of each other
};

/// Little more than a pixel wide or high, few parallelograms touch a third.
Blocks blocks_for(const ParallelogramRow& row) {
    constexpr float little = 1.1F;
    constexpr float most = 7;
    const bool low = row.tallest <= little;
    return {row.widest > little, low ? 1 : static_cast<int>(std::ceil((std::min(row.tallest, most) + 1) / 2))};
}

}  // namespace

class FloorSpreader::Band : public ChannelBand {
  public:
    Band(const FloorFrame& frame, const SurfaceRows& surface, Scratch& scratch, std::vector<RowLedger>& ledger,
         int begin, int end)
        : ChannelBand(frame, scratch.channels, begin, end), s_(scratch), ledger_(ledger), shaper_(frame, surface) {
        s_.pixel.resize(2 * chunk);
        s_.shares.resize(2 * 4 * chunk);
        s_.left_over.resize(chunk);
    }

    /// Pass 1 for row j of the samples, and its ledger; `apart`: none of it can touch the band.
    void add(const LandedSamples& landed, int j, bool apart) {
        const int base = std::clamp(frame_.rows.first + j, 0, frame_.map_height - 1);
        const bool accounts = base >= begin_ && base < end_;
        if (apart && !accounts) return;
        shape_ = &shaper_.shape(landed, j);
        if (accounts) shaper_.account(landed, j, ledger_[j]);
        if (apart) return;
        const Blocks blocks = blocks_for(*shape_);
        const int strips = shape_->upright ? 1 : frame_.strips;
        for (int begin = 0; begin < frame_.columns.count; begin += chunk) {
            const Span span{begin, std::min(begin + chunk, frame_.columns.count)};
            for (int strip = 0; strip < strips; ++strip) add_strips(landed, j, {strip, strips}, blocks, span);
        }
    }

  private:
    /// Number `strip` of all strips.
    struct Which {
        int strip;
        int strips;
    };

    void add_strips(const LandedSamples& landed, int j, Which which, Blocks blocks, Span span) {
        const int count = span.end - span.begin;
        for (int row = 0; row < 2 * blocks.rows; row += 2) {
            share(landed, j, which, blocks, {row, span});
            ring_.add(count, s_.pixel.data(), s_.shares.data());
            if (blocks.wide) ring_.add(count, s_.pixel.data() + chunk, s_.shares.data() + 4 * chunk);
        }
        for (int i = 0; i < count; ++i)
            if (s_.left_over[i]) add_large(landed, span.begin + i, j, which);
    }

    /// Samples of a row, and which two rows of pixels of theirs, counted from the lowest each touches.
    struct Part {
        int row;
        Span span;
    };

    void share(const LandedSamples& landed, int j, Which which, Blocks blocks, Part part) {
        const auto call = [&](auto box, auto wide, auto clips) {
            share_out<box.value, wide.value, clips.value>(landed, j, which, 2 * blocks.rows, part);
        };
        const auto choose = [&](auto box, auto wide) {
            shape_->clipped ? call(box, wide, std::true_type()) : call(box, wide, std::false_type());
        };
        if (shape_->upright)
            blocks.wide ? choose(std::true_type(), std::true_type()) : choose(std::true_type(), std::false_type());
        else
            blocks.wide ? choose(std::false_type(), std::true_type()) : choose(std::false_type(), std::false_type());
    }

    /// A strip of sample (i, j), about its place from the lower left corner of its base pixel.
    static f32::Strip strip_at(const f32::Parallelogram& shape, float x, float y, Which which) {
        return f32::strip_of(shape, {x + 0.5F, y + 0.5F}, static_cast<float>(which.strip),
                             static_cast<float>(which.strips));
    }

    /// For a strip of each sample: the lower left pixels of one or two blocks, and the shares of their pixels. What
    /// touches more than they hold is left over, and has no shares.
    template <bool box, bool wide, bool clips>
    void share_out(const LandedSamples& landed, int j, Which which, int rows_shared, Part part) {
        const float* __restrict x = landed.x.row(j) + part.span.begin;
        const float* __restrict y = landed.y.row(j) + part.span.begin;
        const float* __restrict power = landed.power.row(j) + part.span.begin;
        const float* __restrict width = shape_->width.data() + part.span.begin;
        const float* __restrict height = shape_->height.data() + part.span.begin;
        const float* __restrict slant = shape_->slant.data() + part.span.begin;
        const float* __restrict slide = shape_->slide.data() + part.span.begin;
        int* __restrict pixel = s_.pixel.data();
        int* __restrict pixel_right = s_.pixel.data() + chunk;
        float* __restrict shares = s_.shares.data();
        float* __restrict shares_right = s_.shares.data() + 4 * chunk;
        unsigned char* __restrict left_over = s_.left_over.data();
        const float half_x = static_cast<float>(frame_.half_samples());
        const float half_y = static_cast<float>(frame_.half_channels());
        const ChannelRing ring = ring_;
        const int first_column = frame_.columns.first + part.span.begin + lead;
        const int row_from_oldest = frame_.rows.first + j + part.row - ring.oldest();
        const int rows = this->rows(), count = part.span.end - part.span.begin;
        const float each = 1 / static_cast<float>(which.strips), foot = static_cast<float>(part.row);
        const float most_x = wide ? 4 : 2, most_y = static_cast<float>(rows_shared);
#pragma GCC ivdep
        for (int i = 0; i < count; ++i) {
            f32::Strip s = strip_at({width[i], height[i], box ? 0 : slant[i], box ? 0 : slide[i]}, x[i], y[i], which);
            const float span_x = s.width + f32::abs(s.slant), left = s.centre.x - 0.5F * span_x;
            const float bottom = s.centre.y - 0.5F * s.height;
            // Clamped so that any number, also one that is not, has an integer part.
            const float low_x = f32::floor(f32::clamp(left, -half_x - 5, half_x + 2));
            const float low_y = f32::floor(f32::clamp(bottom, -half_y - 9, half_y + 2));
            const bool large = (left - low_x + span_x > most_x) | (bottom - low_y + s.height > most_y);
            left_over[i] = large;
            s.centre.x -= low_x;
            s.centre.y -= low_y;
            const f32::RowShare a = box ? f32::row_of_box(s, foot) : f32::row_of_strip(s, foot);
            const f32::RowShare b = box ? f32::row_of_box(s, foot + 1) : f32::row_of_strip(s, foot + 1);
            const float light = large ? 0.0F : power[i] * each;
            const auto column_in = [&](float c) { return !clips || f32::abs(low_x + c) <= half_x ? light : 0.0F; };
            const float in_a = !clips || f32::abs(low_y + foot) <= half_y ? 1.0F : 0.0F;
            const float in_b = !clips || f32::abs(low_y + foot + 1) <= half_y ? 1.0F : 0.0F;
            const int column = first_column + i + static_cast<int>(low_x);
            const int row = row_from_oldest + static_cast<int>(low_y);
            pixel[i] = ring.pixel(column, row, rows);
            shares[4 * i] = column_in(0) * in_a * a.one;
            shares[4 * i + 1] = column_in(1) * in_a * ((wide ? a.two : a.all) - a.one);
            shares[4 * i + 2] = column_in(0) * in_b * b.one;
            shares[4 * i + 3] = column_in(1) * in_b * ((wide ? b.two : b.all) - b.one);
            if constexpr (wide) {
                pixel_right[i] = ring.pixel(column + 2, row, rows);
                shares_right[4 * i] = column_in(2) * in_a * (a.three - a.two);
                shares_right[4 * i + 1] = column_in(3) * in_a * (a.all - a.three);
                shares_right[4 * i + 2] = column_in(2) * in_b * (b.three - b.two);
                shares_right[4 * i + 3] = column_in(3) * in_b * (b.all - b.three);
            }
        }
    }

    /// Pass 1 for a strip of one sample, of any size.
    void add_large(const LandedSamples& landed, int i, int j, Which which) {
        const f32::Parallelogram shape{shape_->width[i], shape_->height[i], shape_->slant[i], shape_->slide[i]};
        const float light = landed.power(i, j) / static_cast<float>(which.strips);
        f32::Strip s = strip_at(shape, landed.x(i, j), landed.y(i, j), which);
        const int half = frame_.half_channels();
        const int low = whole(s.centre.y - 0.5F * s.height, half + 1);
        const int high = whole(s.centre.y + 0.5F * s.height, half + 1);
        s.centre.y -= static_cast<float>(low);
        for (int row = std::max(low, -half); row <= std::min(high, half); ++row) {
            const float foot = static_cast<float>(row - low);
            const f32::StripPart part = f32::strip_between(s, foot, foot + 1);
            if (part.part > 0) add_part(part, light * part.part, i, frame_.rows.first + j + row);
        }
    }

    /// Shares out part of a strip in row `row` of the map, each column's share into its pixel's own channel.
    void add_part(f32::StripPart p, float light, int i, int row) {
        const int half = frame_.half_samples();
        const int low = whole(p.centre - p.reach, half + 1), high = whole(p.centre + p.reach, half + 1);
        p.centre -= static_cast<float>(low);
        float below = 0;
        for (int column = low; column <= high; ++column) {
            const float now = f32::part_below(p, static_cast<float>(column - low + 1));
            if (std::abs(column) <= half)
                ring_.add(ring_.pixel(frame_.columns.first + lead + i + column, row - ring_.oldest(), rows()),
                          light * (now - below));
            below = now;
        }
    }

    /// Integer part of a number held within [-bound, bound].
    static int whole(float a, int bound) {
        return static_cast<int>(std::floor(f32::clamp(a, static_cast<float>(-bound), static_cast<float>(bound))));
    }

    Scratch& s_;
    std::vector<RowLedger>& ledger_;
    ParallelogramShaper shaper_;
    const ParallelogramRow* shape_ = nullptr;  ///< of the row at hand
};

double FloorSpreader::collect(const FloorFrame& frame, const SurfaceRows& surface, LandedSamples& landed,
                              Field<float>& map, std::vector<RowLedger>& ledger) {
    scratch_.resize(omp_get_max_threads());
    widen(frame, landed);
    return collect_in_bands(frame, landed, map, [&](int thread, int begin, int end) {
        return Band(frame, surface, scratch_[thread], ledger, begin, end);
    });
}

}  // namespace waterlight
