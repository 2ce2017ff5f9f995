#include "render/surface_levels.hpp"

#include <algorithm>
#include <cmath>

#include "caustics/kernels/surface_lookup.hpp"

namespace waterlight {

namespace {

constexpr int coarsest = 4;           // cells along a side of the last level, at least
constexpr float least_depth = 1e-4F;  // m, of a cell that counts as wet

std::size_t cells_of(const SurfaceLevel& l) {
    return static_cast<std::size_t>(l.nx + 2) * static_cast<std::size_t>(l.ny + 2);
}

std::vector<SurfaceLevel> plan_levels(const Grid& g) {
    std::vector<SurfaceLevel> levels{{0, g.nx, g.ny, 1}};
    while (std::min(levels.back().nx, levels.back().ny) >= 2 * coarsest) {
        const SurfaceLevel& last = levels.back();
        levels.push_back(
            {last.offset + static_cast<int>(cells_of(last)), (last.nx + 1) / 2, (last.ny + 1) / 2, 2 * last.scale});
    }
    return levels;
}

/// The cells of one level, column and row from -1 to n.
struct LevelCells {
    glm::vec4* first;
    int stride;
    LevelCells(std::vector<glm::vec4>& all, const SurfaceLevel& l)
        : first(all.data() + l.offset + (l.nx + 2) + 1), stride(l.nx + 2) {}
    glm::vec4& operator()(int i, int j) const { return first[static_cast<std::ptrdiff_t>(j) * stride + i]; }
};

void copy_fields(const Surface& s, const LevelCells& to) {
#pragma omp parallel for
    for (int j = 0; j < s.grid.ny; ++j) {
        const float *e = s.elevation.row(j), *x = s.slope_x.row(j), *y = s.slope_y.row(j);
        glm::vec4* row = &to(0, j);
        for (int i = 0; i < s.grid.nx; ++i) row[i] = {x[i], y[i], 0, e[i]};
    }
}

/// Mean of the wet cells around a dry one, or a place below the ground.
glm::vec4 beside_shore(const Surface& s, const Field<float>& ground, int i, int j) {
    glm::vec4 sum{0, 0, 0, 0};
    int wet = 0;
    for (int b = std::max(0, j - 1); b <= std::min(s.grid.ny - 1, j + 1); ++b)
        for (int a = std::max(0, i - 1); a <= std::min(s.grid.nx - 1, i + 1); ++a) {
            if (s.elevation(a, b) - ground(a, b) <= least_depth) continue;
            sum += glm::vec4{s.slope_x(a, b), s.slope_y(a, b), 0, s.elevation(a, b)};
            ++wet;
        }
    const float below = ground(i, j) - static_cast<float>(0.05 * s.grid.dx_m);
    if (wet == 0) return {0, 0, 0, below};
    sum *= 1.0F / static_cast<float>(wet);
    sum.w = std::min(sum.w, below);
    return sum;
}

void draw_down_dry(const Surface& s, const Field<float>& ground, const LevelCells& to) {
#pragma omp parallel for
    for (int j = 0; j < s.grid.ny; ++j)
        for (int i = 0; i < s.grid.nx; ++i)
            if (s.elevation(i, j) - ground(i, j) <= least_depth) to(i, j) = beside_shore(s, ground, i, j);
}

glm::vec4 mean_of_four(const LevelCells& from, int nx, int ny, int i, int j) {
    const int i0 = 2 * i, i1 = std::min(2 * i + 1, nx - 1), j0 = 2 * j, j1 = std::min(2 * j + 1, ny - 1);
    const std::array four{from(i0, j0), from(i1, j0), from(i0, j1), from(i1, j1)};
    glm::vec4 mean{0, 0, 0, 0};
    float square = 0;
    for (const glm::vec4& c : four) {
        mean += 0.25F * c;
        square += 0.25F * (c.x * c.x + c.y * c.y);
    }
    mean.z += std::max(0.0F, 0.5F * (square - mean.x * mean.x - mean.y * mean.y));
    return mean;
}

/// What a cell of the margin holds: as caustics/kernels/surface_lookup.glsl has it beyond each kind of side.
glm::vec4 margin_cell(const Surface& s, const LevelCells& cells, const SurfaceLevel& l, int i, int j) {
    const f64::AxisPlace x = f64::place_on_axis(i, 0, l.nx, side_number(s.boundary.x), 0.5);
    const f64::AxisPlace y = f64::place_on_axis(j, 0, l.ny, side_number(s.boundary.y), 0.5);
    glm::vec4 cell = cells(x.low, y.low);
    cell.x *= static_cast<float>(x.mirror_low);
    cell.y *= static_cast<float>(y.mirror_low);
    cell.w +=
        static_cast<float>(s.tilt.x * s.grid.width_m() * x.wraps_low + s.tilt.y * s.grid.height_m() * y.wraps_low);
    return cell;
}

void fill_margin(const Surface& s, const LevelCells& cells, const SurfaceLevel& l) {
    for (int i = -1; i <= l.nx; ++i)
        for (const int j : {-1, l.ny}) cells(i, j) = margin_cell(s, cells, l, i, j);
    for (int j = 0; j < l.ny; ++j)
        for (const int i : {-1, l.nx}) cells(i, j) = margin_cell(s, cells, l, i, j);
}

void measure(const Surface& s, SurfaceLevels& out) {
    double sum_x = 0, sum_y = 0, squares = 0, changes = 0;
    float low = s.elevation.data()[0], high = low;
#pragma omp parallel for reduction(+ : sum_x, sum_y, squares, changes) reduction(max : high) reduction(min : low)
    for (int j = 0; j < s.grid.ny; ++j) {
        const float *e = s.elevation.row(j), *x = s.slope_x.row(j), *y = s.slope_y.row(j);
        for (int i = 0; i < s.grid.nx; ++i) {
            sum_x += x[i];
            sum_y += y[i];
            squares += x[i] * x[i] + y[i] * y[i];
            low = std::min(low, e[i]);
            high = std::max(high, e[i]);
            if (i > 0) changes += std::pow((x[i] - x[i - 1]) / s.grid.dx_m, 2);
            if (j > 0) changes += std::pow((y[i] - s.slope_y(i, j - 1)) / s.grid.dy_m, 2);
        }
    }
    const auto count = static_cast<double>(s.grid.cells());
    sum_x /= count;
    sum_y /= count;
    out.mean_variance = std::max(0.0, 0.5 * (squares / count - sum_x * sum_x - sum_y * sum_y));
    out.curvature_per_m = std::sqrt(0.5 * changes / count);
    out.lowest_m = low;
    out.highest_m = high;
}

}  // namespace

void fill_levels(const Surface& s, const Field<float>* ground, SurfaceLevels& out) {
    out.levels = plan_levels(s.grid);
    const SurfaceLevel& last = out.levels.back();
    out.beyond = {last.offset + static_cast<int>(cells_of(last)), 1, 1, 1};
    out.cells.resize(static_cast<std::size_t>(out.beyond.offset) + cells_of(out.beyond));
    measure(s, out);
    for (std::size_t k = 0; k < out.levels.size(); ++k) {
        const SurfaceLevel& level = out.levels[k];
        const LevelCells cells(out.cells, level);
        if (k == 0) {
            copy_fields(s, cells);
            if (ground != nullptr) draw_down_dry(s, *ground, cells);
        } else {
            const SurfaceLevel& finer = out.levels[k - 1];
            const LevelCells from(out.cells, finer);
            for (int j = 0; j < level.ny; ++j)
                for (int i = 0; i < level.nx; ++i) cells(i, j) = mean_of_four(from, finer.nx, finer.ny, i, j);
        }
        fill_margin(s, cells, level);
    }
    const bool still = s.boundary.x != Side::periodic && s.boundary.y != Side::periodic;
    const glm::vec4 far{s.tilt.x, s.tilt.y, still ? 0 : out.mean_variance, 0};
    std::fill_n(out.cells.begin() + out.beyond.offset, cells_of(out.beyond), far);
}

std::vector<float> padded_ground(const Surface& surface, const Field<float>& ground) {
    const int nx = ground.nx(), ny = ground.ny();
    const auto beside = [](int k, int n, Side side) {
        return side == Side::periodic ? (k + n) % n : std::clamp(k, 0, n - 1);
    };
    std::vector<float> all;
    all.reserve(static_cast<std::size_t>(nx + 2) * static_cast<std::size_t>(ny + 2));
    for (int j = -1; j <= ny; ++j)
        for (int i = -1; i <= nx; ++i)
            all.push_back(ground(beside(i, nx, surface.boundary.x), beside(j, ny, surface.boundary.y)));
    return all;
}

}  // namespace waterlight
