#include "caustics/beam_ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "caustics/axis_place.hpp"
#include "caustics/first_crossing.hpp"
#include "sim/error.hpp"

namespace waterlight {

BeamGround::BeamGround(const Grid& grid, Boundary boundary, Field<float> height_m)
    : grid_(grid), boundary_(boundary), height_(std::move(height_m)) {
    if (height_.nx() != grid.nx || height_.ny() != grid.ny)
        throw InputError(fmt::format("ground: {} x {} heights; {} x {} as the surface has cells", height_.nx(),
                                     height_.ny(), grid.nx, grid.ny));
    if (!std::ranges::all_of(height_.values(), [](float h) { return std::isfinite(h); }))
        throw InputError("ground: a height is not finite");
    const auto [low, high] = std::ranges::minmax_element(height_.values());
    lowest_ = *low;
    highest_ = *high;
}

double BeamGround::height_m(glm::dvec2 at_m) const {
    const f64::AxisPlace x = axis_place(at_m.x, grid_.x_m(0), grid_.dx_m, grid_.nx, boundary_.x);
    const f64::AxisPlace y = axis_place(at_m.y, grid_.y_m(0), grid_.dy_m, grid_.ny, boundary_.y);
    return f64::bilinear(height_(x.low, y.low), height_(x.high, y.low), height_(x.low, y.high), height_(x.high, y.high),
                         x.weight, y.weight);
}

double BeamGround::end_z(glm::dvec3 from_m, glm::dvec2 travel) const {
    const double below = height_m(glm::dvec2(from_m));
    if (from_m.z - below <= film_m) return std::max(from_m.z, below) + film_m;
    const double first = std::max(0.0, from_m.z - highest_), last = from_m.z - lowest_;
    const double cells = glm::length(travel) * (last - first) / std::min(grid_.dx_m, grid_.dy_m);
    const auto at = [&](double descent) { return height_m(glm::dvec2(from_m) + descent * travel); };
    const int steps = std::max(1, static_cast<int>(std::ceil(cells)));
    const double descent =
        first_crossing({first, last, steps}, [&](double down) { return from_m.z - down - at(down); });
    return at(descent);
}

}  // namespace waterlight
