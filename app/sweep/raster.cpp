#include "app/sweep/raster.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "app/readings.hpp"
#include "scenarios/origin.hpp"

namespace waterlight {

namespace {

constexpr int least_pixels = 8;
constexpr int most_points = 1024;

}  // namespace

glm::ivec2 common_raster(const std::vector<Setting>& settings) {
    glm::ivec2 raster{0, 0}, greatest{0, 0};
    for (const Setting& setting : settings) {
        if (!setting.scenario.floor) continue;
        const glm::ivec2 pixels = setting.scenario.floor->pixels;
        raster = {std::gcd(raster.x, pixels.x), std::gcd(raster.y, pixels.y)};
        greatest = glm::max(greatest, pixels);
    }
    for (int axis = 0; axis < 2; ++axis)
        if (raster[axis] < std::min(least_pixels, greatest[axis]))
            reject("--vary", "caustics.floor.pixels",
                   fmt::format("maps with {} pixels in common along {}", raster[axis], axis == 0 ? "x" : "y"),
                   "counts of pixels with a common divisor of at least 8, such as [256, 192],[512, 384]");
    return raster;
}

Field<float> averaged(const Field<float>& map, glm::ivec2 raster) {
    assert(map.nx() % raster.x == 0 && map.ny() % raster.y == 0);
    const glm::ivec2 box{map.nx() / raster.x, map.ny() / raster.y};
    Field<float> means(raster.x, raster.y);
    for (int j = 0; j < raster.y; ++j) {
        for (int i = 0; i < raster.x; ++i) {
            double sum = 0;
            for (int b = 0; b < box.y; ++b)
                for (int a = 0; a < box.x; ++a) sum += map(i * box.x + a, j * box.y + b);
            means(i, j) = static_cast<float>(sum / (static_cast<double>(box.x) * box.y));
        }
    }
    return means;
}

glm::ivec2 common_points(const std::vector<Setting>& settings) {
    glm::ivec2 points{1, 1};
    for (const Setting& setting : settings) points = glm::max(points, setting.scenario.domain.cells);
    return glm::min(points, glm::ivec2(most_points));
}

Field<float> elevations(const Surface& surface, glm::ivec2 points) {
    const Grid& g = surface.grid;
    const glm::dvec2 step{g.width_m() / points.x, g.height_m() / points.y};
    Field<float> field(points.x, points.y);
#pragma omp parallel for schedule(static)
    for (int j = 0; j < points.y; ++j)
        for (int i = 0; i < points.x; ++i)
            field(i, j) = static_cast<float>(
                elevation_at(surface, glm::dvec2{g.x0_m, g.y0_m} + step * glm::dvec2(i + 0.5, j + 0.5)));
    return field;
}

void RelativeError::add(const Field<float>& found, const Field<float>& expected) {
    assert(found.size() == expected.size());
    for (std::size_t n = 0; n < expected.size(); ++n) {
        const double e = expected.data()[n], d = found.data()[n] - e;
        difference_ += d * d;
        square_ += e * e;
    }
}

double RelativeError::value() const {
    return square_ > 0 ? std::sqrt(difference_ / square_) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace waterlight
