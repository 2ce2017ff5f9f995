#include "caustics/ellipse_taps.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace waterlight {

namespace {

/// The ellipse as a quadratic form: points (x, y) with |x - lean y| <= width sqrt(1 - y^2 / height^2).
struct Ellipse {
    double width = 0, height = 0, lean = 0;
    double right = 0;  ///< its greatest x

    explicit Ellipse(Spread s) {
        height = 2 * std::sqrt(s.yy);
        right = 2 * std::sqrt(s.xx);
        lean = s.yy > 0 ? s.xy / s.yy : 0;
        width = 2 * std::sqrt(std::max(0.0, s.xx - lean * s.xy));
    }
    double area() const { return std::numbers::pi * width * height; }
    double chord(double y) const {
        const double part = 1 - y * y / (height * height);
        return part > 0 ? width * std::sqrt(part) : 0;
    }
};

/// Takes a pixel's spread off, and leaves an ellipse of a thousandth of a pixel where nothing is left.
Spread narrowed(Spread s) {
    constexpr double pixel = 1.0 / 12, least = 2.5e-7;
    const double a = s.xx - pixel, b = s.yy - pixel, mean = 0.5 * (a + b), half = 0.5 * (a - b);
    const double root = std::hypot(half, s.xy);
    const double major = std::max(mean + root, least), minor = std::max(mean - root, least);
    const double cos2 = root > 0 ? half / root : 1, sin2 = root > 0 ? s.xy / root : 0;
    const double middle = 0.5 * (major + minor), apart = 0.5 * (major - minor);
    return {middle + apart * cos2, apart * sin2, middle - apart * cos2};
}

/// Adds the area of the part of each pixel of a row that the ellipse covers between y and y + dy. The chord is taken as
/// a rectangle with its middle's ends.
void add_slice(const Ellipse& e, double y, double dy, std::vector<double>& row, int reach) {
    const double middle = e.lean * y, half = e.chord(y);
    const double begin = middle - half + reach + 0.5, end = middle + half + reach + 0.5;
    for (int i = std::max(0, static_cast<int>(begin)); i < static_cast<int>(row.size()) && i < end; ++i)
        row[i] += dy * std::max(0.0, std::min(end, i + 1.0) - std::max(begin, static_cast<double>(i)));
}

/// Areas of the pixels of row dy, in slices so thin that the weights are good to 1e-6.
std::vector<double> areas_of_row(const Ellipse& e, int dy, int reach) {
    constexpr int slices = 512;
    std::vector<double> row(2 * static_cast<std::size_t>(reach) + 1);
    const double low = std::max(dy - 0.5, -e.height), high = std::min(dy + 0.5, e.height);
    for (int k = 0; k < slices; ++k)
        add_slice(e, low + (high - low) * (k + 0.5) / slices, (high - low) / slices, row, reach);
    return row;
}

/// The longest run of pixels that the ellipse covers whole.
void find_run(const std::vector<double>& areas, int reach, EllipseTaps::Row& row) {
    constexpr double whole = 1 - 1e-6;
    const auto first = std::find_if(areas.begin(), areas.end(), [](double a) { return a > whole; });
    const auto last = std::find_if(first, areas.end(), [](double a) { return a <= whole; });
    row.run_begin = static_cast<int>(first - areas.begin()) - reach;
    row.run_end = static_cast<int>(last - areas.begin()) - reach;
}

}  // namespace

EllipseTaps::EllipseTaps(Spread spread) {
    const Ellipse e(narrowed(spread));
    reach_ = {static_cast<int>(std::floor(e.right + 0.5)), static_cast<int>(std::floor(e.height + 0.5))};
    std::vector<std::vector<double>> areas;
    double total = 0;
    for (int dy = -reach_.y; dy <= reach_.y; ++dy) {
        areas.push_back(areas_of_row(e, dy, reach_.x));
        for (const double a : areas.back()) total += a;
    }
    full_weight_ = static_cast<float>(1 / total);
    for (int dy = -reach_.y; dy <= reach_.y; ++dy) {
        const std::vector<double>& of_row = areas[static_cast<std::size_t>(dy + reach_.y)];
        Row row{dy, 0, 0, {}, {}};
        find_run(of_row, reach_.x, row);
        for (int dx = -reach_.x; dx <= reach_.x; ++dx) {
            const double area = of_row[static_cast<std::size_t>(dx + reach_.x)];
            const bool in_run = dx >= row.run_begin && dx < row.run_end;
            if (in_run || area == 0) continue;
            row.edge_dx.push_back(dx);
            row.edge_weight.push_back(static_cast<float>(area / total));
        }
        rows_.push_back(std::move(row));
    }
}

namespace {

/// sums[i] = the sum of the values before i.
void sum_along(const float* values, int count, double* sums) {
    sums[0] = 0;
    for (int i = 0; i < count; ++i) sums[i + 1] = sums[i] + values[i];
}

/// to[i] += weight (sums[i + end] - sums[i + begin]).
void add_run(const double* __restrict begin, const double* __restrict end, float weight, int count,
             float* __restrict to) {
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) to[i] += weight * static_cast<float>(end[i] - begin[i]);
}

void add_edge(const float* __restrict from, float weight, int count, float* __restrict to) {
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) to[i] += weight * from[i];
}

}  // namespace

void convolve(const EllipseTaps& taps, const Field<float>& from, Field<float>& to) {
    const glm::ivec2 reach = taps.reach();
    assert(from.nx() == to.nx() + 2 * reach.x && from.ny() == to.ny() + 2 * reach.y);
    Field<double> sums(from.nx() + 1, from.ny());
#pragma omp parallel
    {
#pragma omp for schedule(static)
        for (int j = 0; j < from.ny(); ++j) sum_along(from.row(j), from.nx(), sums.row(j));
#pragma omp for schedule(static)
        for (int j = 0; j < to.ny(); ++j) {
            float* row = to.row(j);
            std::fill_n(row, to.nx(), 0.0F);
            for (const EllipseTaps::Row& tap : taps.rows()) {
                const float* line = from.row(j + reach.y + tap.dy) + reach.x;
                const double* sum = sums.row(j + reach.y + tap.dy) + reach.x;
                if (tap.run_end > tap.run_begin)
                    add_run(sum + tap.run_begin, sum + tap.run_end, taps.full_weight(), to.nx(), row);
                for (std::size_t k = 0; k < tap.edge_dx.size(); ++k)
                    add_edge(line + tap.edge_dx[k], tap.edge_weight[k], to.nx(), row);
            }
        }
    }
}

}  // namespace waterlight
