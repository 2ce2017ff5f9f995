#include "caustics/splat/splat_spread.hpp"

#include <algorithm>
#include <cmath>

namespace waterlight {

namespace {

/// First and second difference along one axis of the lattice, pixels.
struct Difference {
    glm::dvec2 first{0, 0}, second{0, 0};
};

/// Of the landing of vertex k between two others (-1: none); `step` where it has none.
Difference difference(const SplatCloud& c, int k, int before, int after, glm::dvec2 step) {
    const auto landed = [&](int n) { return n >= 0 && std::isfinite(c.pixel[n].x) && std::isfinite(c.pixel[n].y); };
    const glm::dvec2 at = c.pixel[k];
    if (landed(before) && landed(after)) {
        const glm::dvec2 low = at - c.pixel[before], high = c.pixel[after] - at;
        // Objects have edges, across which light jumps: then the footprint is that of the side without.
        const double l = glm::length(low), h = glm::length(high);
        const bool jumps = c.columns == 0 && std::max(l, h) > 3 * (std::min(l, h) + glm::length(step));
        if (jumps) return {l < h ? low : high, {0, 0}};
        return {0.5 * (low + high), high - low};
    }
    if (landed(before)) return {at - c.pixel[before], {0, 0}};
    return {landed(after) ? c.pixel[after] - at : step, {0, 0}};
}

/// How many vertices lie between one and the end of its lattice, which is behind it (< 0: before it); 0 where that is
/// too far for its splat to feel.
float away_from_end(bool ends, int vertex, int count) {
    const float behind = static_cast<float>(vertex) + 0.5F, before = static_cast<float>(count - vertex) - 0.5F;
    const float nearest = behind <= before ? behind : -before;
    return ends && std::abs(nearest) < f32::splat_reach * f32::splat_deviation ? nearest : 0;
}

/// From a vertex of a lattice to the next along an axis.
int step_along(const SplatCloud& cloud, int axis) { return axis == 0 ? 1 : cloud.columns; }

/// How the landing changes along one of the lattice's axes (0 or 1), and along the other.
struct Change {
    int axis;
    glm::vec2 a, b;
};

f32::SplatEdge edge_of(const SplatFrame& frame, const SplatCloud& cloud, const Splat& splat, int k, const Change& by) {
    const VertexLattice& l = frame.lattice;
    const bool lattice = cloud.columns > 0;
    const glm::ivec2 vertex = lattice ? l.first + glm::ivec2{k % cloud.columns, k / cloud.columns}
                                      : cloud.vertex[static_cast<std::size_t>(k)];
    const float away = away_from_end(frame.ends[by.axis], vertex[by.axis], l.domain[by.axis]);
    if (away == 0) return {};
    const float sign = away > 0 ? 1.0F : -1.0F;
    // By the landing of vertices beyond the edge, of the water's mirror image; else by differences.
    glm::vec2 to_edge = -away * by.a - splat.shape.shift, mirrored = -2 * away * by.a;
    if (lattice) {
        const int step = away > 0 ? -step_along(cloud, by.axis) : step_along(cloud, by.axis);
        const int last = k + static_cast<int>(std::abs(away)) * step;
        const auto at = [&](int n) { return cloud.pixel[static_cast<std::size_t>(n)]; };
        const glm::dvec2 edge = (9.0 * (at(last) + at(last + step)) - (at(last - step) + at(last + 2 * step))) / 16.0;
        to_edge = glm::vec2(edge - splat.centre);
        const int image = last + (last - k) + step;
        const double half_variance = 0.5 * f32::splat_deviation * f32::splat_deviation;
        const int across = step_along(cloud, 1 - by.axis);
        const glm::dvec2 bend =
            at(image - step) + at(image + step) + at(image - across) + at(image + across) - 4.0 * at(image);
        mirrored = glm::vec2(at(image) + half_variance * bend - splat.centre);
    }
    return f32::splat_edge(sign * by.a, by.b, to_edge, mirrored);
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
        // Light of a splat that is wider than three periods is thin, and what it has farther away is outside.
        const double most = std::min(reach, period);
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

/// [begin, end)
struct Vertices {
    int begin = 0, end = 0;
};

/// The light of some rows of vertices.
class Band {
  public:
    Band(const SplatOptions& options, const SplatFrame& frame, const SplatCloud& cloud, Vertices vertices,
         std::vector<BandSplat>& scratch)
        : cloud_(cloud), splats_(scratch) {
        splats_.clear();
        const auto box = box_about(frame.plan);
        double lowest = 1e300, highest = -1e300;
        for (int k = vertices.begin; k < vertices.end; ++k) {
            if (!(cloud.power_w[k] > 0)) continue;
            const Splat splat = splat_of(options, frame, cloud, k);
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
        part_.first.y = static_cast<int>(std::floor(std::clamp(lowest, 0.0, height)));
        const int end_row = static_cast<int>(std::ceil(std::clamp(highest + 1, 0.0, height)));
        part_.power_w = Field<float>(frame.plan.width, std::max(0, end_row - part_.first.y));
        lay();
    }

    void add_to(Field<double>& power_w, FloorLedger& ledger) const {
        for (int j = 0; j < part_.power_w.ny(); ++j) {
            const float* __restrict from = part_.power_w.row(j);
            double* __restrict to = power_w.row(part_.first.y + j);
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
            count_beside(vertex, 1 - laid / cloud_.power_w[vertex]);
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

    const SplatCloud& cloud_;
    std::vector<BandSplat>& splats_;
    MapPart part_;
    double outside_w_ = 0, entered_w_ = 0;
};

}  // namespace

glm::dvec2 Splat::reach() const {
    const double along = shape.along, across = shape.across + std::abs(shape.lean) * shape.along;
    return static_cast<double>(f32::splat_reach) *
           (shape.transposed != 0 ? glm::dvec2{across, along} : glm::dvec2{along, across});
}

Splat splat_of(const SplatOptions& options, const SplatFrame& frame, const SplatCloud& cloud, int k) {
    const glm::dvec2 at = cloud.pixel[k];
    Splat splat{at, {}, static_cast<float>(cloud.power_w[k])};
    if (options.size == SplatOptions::Size::fixed) {
        splat.shape = f32::round_splat(static_cast<float>(options.radius_pixels));
        return splat;
    }
    const glm::ivec4 n = cloud.columns > 0 ? glm::ivec4{k - 1, k + 1, k - cloud.columns, k + cloud.columns}
                                           : cloud.neighbours[static_cast<std::size_t>(k)];
    const Difference by_x = difference(cloud, k, n[0], n[1], cloud.step_x);
    const Difference by_y = difference(cloud, k, n[2], n[3], cloud.step_y);
    const glm::vec2 a(by_x.first), b(by_y.first);
    splat.shape = f32::landed_splat(a, b, glm::vec2(by_x.second), glm::vec2(by_y.second));
    splat.centre += glm::dvec2(splat.shape.shift);
    splat.edges[0] = edge_of(frame, cloud, splat, k, {0, a, b});
    splat.edges[1] = edge_of(frame, cloud, splat, k, {1, b, a});
    splat.near_edge = splat.edges[0].normal != glm::vec2{0, 0} || splat.edges[1].normal != glm::vec2{0, 0};
    return splat;
}

void spread(const SplatOptions& options, const SplatFrame& frame, SplatCloud& cloud, Field<double>& power_w) {
    // Bands of so many vertices' rows, added in order: the sums do not depend on the number of threads.
    constexpr int band = 32;
    const int rows = static_cast<int>(cloud.row_begin.size()) - 1, bands = (rows + band - 1) / band;
#pragma omp parallel
    {
        std::vector<BandSplat> scratch;
#pragma omp for schedule(static, 1) ordered
        for (int b = 0; b < bands; ++b) {
            const Vertices vertices{cloud.row_begin[b * band], cloud.row_begin[std::min(rows, (b + 1) * band)]};
            const Band light(options, frame, cloud, vertices, scratch);
#pragma omp ordered
            light.add_to(power_w, cloud.ledger);
        }
    }
}

}  // namespace waterlight
