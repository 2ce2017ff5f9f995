#include "caustics/splat/splat_spread.hpp"

#include <algorithm>
#include <cmath>

namespace waterlight {

namespace {

constexpr int lanes = 8;

/// Part of the map: its rows [first_row, first_row + rows).
struct Part {
    int first_row = 0;
    Field<float> power_w;
};

/// Cells [first, end) of one axis.
struct CellSpan {
    int first = 0, end = 0;
};

CellSpan cells_within(float middle, float half, int from, int to) {
    const auto cell = [&](float x) { return static_cast<int>(std::floor(std::clamp(x, -1e9F, 1e9F))); };
    return {std::max(from, cell(middle - half)), std::min(to, cell(middle + half) + 1)};
}

/// Adds a part of a splat's light along one line of cells, `stride` apart; returns how much of it lies there.
float add_line(const f32::SplatLine& line, float middle, float power, CellSpan limits, float* to,
               std::ptrdiff_t stride) {
    const CellSpan cells = cells_within(middle, f32::splat_reach * line.deviation, limits.first, limits.end);
    const float per = 1 / line.deviation;
    float laid = 0;
    for (int begin = cells.first; begin < cells.end; begin += lanes - 1) {
        float below[lanes];
#pragma GCC ivdep
        for (int k = 0; k < lanes; ++k) below[k] = f32::splat_below((static_cast<float>(begin + k) - middle) * per);
        const int count = std::min(lanes - 1, cells.end - begin);
        for (int k = 0; k < count; ++k) to[(begin + k) * stride] += power * (below[k + 1] - below[k]);
        laid += power * (below[count] - below[0]);
    }
    return laid;
}

/// Adds a splat to a part of the map. Returns the part of its light that lies there.
float add_splat(const Splat& splat, Part& part) {
    const int width = part.power_w.nx();
    // About the cell of the centre, so that floats hold the rest.
    const glm::dvec2 cell = glm::floor(splat.centre);
    const glm::vec2 centre(splat.centre - cell);
    const glm::ivec2 base(cell);
    const CellSpan columns{-base.x, width - base.x},
        rows{part.first_row - base.y, part.first_row + part.power_w.ny() - base.y};
    float* origin = part.power_w.data() + (static_cast<std::ptrdiff_t>(base.y - part.first_row) * width + base.x);
    const f32::SplatShape& s = splat.shape;
    const bool upright = s.transposed != 0;
    const float major = upright ? centre.y : centre.x, minor = upright ? centre.x : centre.y;
    const CellSpan along = upright ? rows : columns, across = upright ? columns : rows;
    const std::ptrdiff_t major_stride = upright ? width : 1, minor_stride = upright ? 1 : width;
    const CellSpan cells = cells_within(major, f32::splat_reach * s.along, along.first, along.end);
    const float per = 1 / s.along;
    float laid = 0;
    for (int c = cells.first; c < cells.end; ++c) {
        const float low = (static_cast<float>(c) - major) * per;
        const f32::SplatLine line = f32::splat_line(s, low, low + per);
        laid += line.share *
                add_line(line, minor + line.middle, splat.power_w * line.share, across, origin + c * major_stride,
                         minor_stride) /
                std::max(splat.power_w * line.share, 1e-30F);
    }
    return laid;
}

glm::dvec2 difference(const SplatCloud& c, glm::dvec2 at, int before, int after, glm::dvec2 step, glm::dvec2& bend) {
    const auto landed = [&](int k) { return k >= 0 && std::isfinite(c.pixel[k].x) && std::isfinite(c.pixel[k].y); };
    bend = {0, 0};
    const bool has_before = landed(before), has_after = landed(after);
    if (has_before && has_after) {
        bend = c.pixel[after] - 2.0 * at + c.pixel[before];
        return 0.5 * (c.pixel[after] - c.pixel[before]);
    }
    if (has_before) return at - c.pixel[before];
    return has_after ? c.pixel[after] - at : step;
}

/// Copies of a splat to places on the map, where what lands repeats.
template <class Take>
void for_each_copy(const SplatFrame& f, const std::pair<glm::dvec2, glm::dvec2>& map_box, const Splat& splat,
                   Take&& take) {
    const glm::dvec2 at = f.plan.position_m(splat.centre), half = splat.reach() * f.plan.pitch_m;
    const double reach = glm::length(half);
    glm::ivec2 low{0, 0}, high{0, 0};
    for (int axis = 0; axis < 2; ++axis) {
        const double period = f.period_m[axis];
        if (period == 0) continue;
        // No farther than splats of some size reach: one that is wider than the map many times over is laid once.
        const double most = std::min(reach, 4 * period);
        low[axis] = static_cast<int>(std::ceil((map_box.first[axis] - most - at[axis]) / period));
        high[axis] = static_cast<int>(std::floor((map_box.second[axis] + most - at[axis]) / period));
    }
    const glm::dvec2 across = f.to_pixels * glm::dvec2{f.period_m.x, 0}, up = f.to_pixels * glm::dvec2{0, f.period_m.y};
    const glm::dvec2 size{f.plan.width, f.plan.height}, extent = splat.reach();
    for (int b = low.y; b <= high.y; ++b)
        for (int a = low.x; a <= high.x; ++a) {
            Splat copy = splat;
            copy.centre += static_cast<double>(a) * across + static_cast<double>(b) * up;
            const glm::dvec2 from = copy.centre - extent, to = copy.centre + extent;
            if (to.x >= 0 && to.y >= 0 && from.x <= size.x && from.y <= size.y) take(copy);
        }
}

struct BandSplat {
    Splat splat;
    int vertex;
};

/// The light of some rows of vertices.
class Band {
  public:
    Band(const SplatOptions& options, const SplatFrame& frame, const SplatCloud& cloud, int begin, int end)
        : frame_(frame), cloud_(cloud) {
        const auto box = box_about(frame.plan);
        double lowest = 1e300, highest = -1e300;
        for (int k = begin; k < end; ++k) {
            if (!(cloud.power_w[k] > 0)) continue;
            const Splat splat = splat_of(options, cloud, k);
            const std::size_t before = splats_.size();
            for_each_copy(frame, box, splat, [&](const Splat& copy) {
                const double reach = copy.reach().y;
                lowest = std::min(lowest, copy.centre.y - reach);
                highest = std::max(highest, copy.centre.y + reach);
                splats_.push_back({copy, k});
            });
            if (splats_.size() == before) count_beside(k, 1);
        }
        const double height = frame.plan.height;
        part_.first_row = static_cast<int>(std::floor(std::clamp(lowest, 0.0, height)));
        const int end_row = static_cast<int>(std::ceil(std::clamp(highest + 1, 0.0, height)));
        part_.power_w = Field<float>(frame.plan.width, std::max(0, end_row - part_.first_row));
        lay();
    }

    void add_to(Field<double>& power_w, FloorLedger& ledger) const {
        for (int j = 0; j < part_.power_w.ny(); ++j) {
            const float* __restrict from = part_.power_w.row(j);
            double* __restrict to = power_w.row(part_.first_row + j);
            for (int i = 0; i < power_w.nx(); ++i) to[i] += from[i];
        }
        ledger.outside_w += outside_w_;
        ledger.entered_w += entered_w_;
    }

  private:
    void lay() {
        for (std::size_t n = 0; n < splats_.size();) {
            const int vertex = splats_[n].vertex;
            double laid = 0;
            for (; n < splats_.size() && splats_[n].vertex == vertex; ++n) laid += add_splat(splats_[n].splat, part_);
            count_beside(vertex, 1 - laid);
        }
    }

    /// Of a vertex's light, what does not lie on the map; less than 0 where copies lie on it more than once.
    void count_beside(int k, double part) {
        const double power = cloud_.power_w[k];
        if (!cloud_.own[k])
            entered_w_ += power * (1 - part);
        else if (part > 0)
            outside_w_ += power * part;
        else
            entered_w_ -= power * part;
    }

    const SplatFrame& frame_;
    const SplatCloud& cloud_;
    std::vector<BandSplat> splats_;
    Part part_;
    double outside_w_ = 0, entered_w_ = 0;
};

}  // namespace

glm::dvec2 Splat::reach() const {
    const double along = shape.along, leaning = shape.lean * shape.along, across = shape.across;
    const glm::dvec2 deviation{along, std::sqrt(leaning * leaning + across * across)};
    return static_cast<double>(f32::splat_reach) *
           (shape.transposed != 0 ? glm::dvec2{deviation.y, deviation.x} : deviation);
}

Splat splat_of(const SplatOptions& options, const SplatCloud& cloud, int k) {
    const glm::dvec2 at = cloud.pixel[k];
    const auto power = static_cast<float>(cloud.power_w[k]);
    if (options.size == SplatOptions::Size::fixed)
        return {at, f32::round_splat(static_cast<float>(options.radius_pixels)), power};
    const glm::ivec4 n = cloud.columns > 0 ? glm::ivec4{k - 1, k + 1, k - cloud.columns, k + cloud.columns}
                                           : cloud.neighbours[static_cast<std::size_t>(k)];
    glm::dvec2 bend_a, bend_b;
    const glm::dvec2 a = difference(cloud, at, n[0], n[1], cloud.step_x, bend_a);
    const glm::dvec2 b = difference(cloud, at, n[2], n[3], cloud.step_y, bend_b);
    const f32::SplatShape shape = f32::landed_splat(glm::vec2(a), glm::vec2(b), glm::vec2(bend_a), glm::vec2(bend_b));
    return {at + glm::dvec2(shape.shift), shape, power};
}

void spread(const SplatOptions& options, const SplatFrame& frame, SplatCloud& cloud, Field<double>& power_w) {
    // Bands of so many vertices' rows, added in order: the sums do not depend on the number of threads.
    constexpr int band = 32;
    const int rows = static_cast<int>(cloud.row_begin.size()) - 1, bands = (rows + band - 1) / band;
#pragma omp parallel for schedule(static, 1) ordered
    for (int b = 0; b < bands; ++b) {
        const Band light(options, frame, cloud, cloud.row_begin[b * band],
                         cloud.row_begin[std::min(rows, (b + 1) * band)]);
#pragma omp ordered
        light.add_to(power_w, cloud.ledger);
    }
}

}  // namespace waterlight
