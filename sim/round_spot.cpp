#include "sim/round_spot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waterlight {

// exp(-q) and what multiplies it are below double rounding beyond q = 40.
static constexpr double reach_in_radii = 6.33;

RoundSpot::RoundSpot(glm::dvec2 at_m, double radius_m, const Grid& grid, Boundary boundary)
    : grid_(grid),
      per_radius2_(1 / (radius_m * radius_m)),
      xs_(images(at_m.x, reach_in_radii * radius_m, {grid.x0_m, grid.dx_m, grid.nx, boundary.x})),
      ys_(images(at_m.y, reach_in_radii * radius_m, {grid.y0_m, grid.dy_m, grid.ny, boundary.y})) {}

std::vector<RoundSpot::Image> RoundSpot::images(double at_m, double reach_m, const Axis& axis) {
    const double size = axis.cell_m * axis.count;
    std::vector<Image> found;
    const auto bound = [&](double x) {
        const double cell = std::ceil((x - axis.start_m) / axis.cell_m - 0.5);
        return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(axis.count)));
    };
    const auto add = [&](double x) {
        const Image image{x, {bound(x - reach_m), bound(x + reach_m)}};
        if (image.cells.from < image.cells.to) found.push_back(image);
    };
    if (axis.side == Side::absorbing) {
        add(at_m);
        return found;
    }
    const int turns = static_cast<int>(std::ceil(reach_m / size)) + 1;
    const double period = axis.side == Side::wall ? 2 * size : size;
    for (int n = -turns; n <= turns; ++n) {
        add(at_m + n * period);
        if (axis.side == Side::wall) add(2 * axis.start_m - at_m + n * period);
    }
    return found;
}

CellRange RoundSpot::hull(const std::vector<Image>& images) {
    CellRange all{std::numeric_limits<int>::max(), 0};
    for (const Image& image : images) {
        all.from = std::min(all.from, image.cells.from);
        all.to = std::max(all.to, image.cells.to);
    }
    return all;
}

}  // namespace waterlight
