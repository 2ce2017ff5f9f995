#include "sim/bathymetry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/error.hpp"
#include "sim/kernels/ground.hpp"

namespace waterlight {

namespace {

/// `offset` in axes that are turned by an angle; along the first axis x, across it y.
glm::dvec2 turned(glm::dvec2 offset, double direction_deg) {
    const double angle = direction_deg * std::numbers::pi / 180;
    // Along the axes of the grid nothing is lost to rounding.
    const double quarter = std::remainder(direction_deg, 90) == 0 ? 0 : 1;
    const double c = quarter == 0 ? std::round(std::cos(angle)) : std::cos(angle);
    const double s = quarter == 0 ? std::round(std::sin(angle)) : std::sin(angle);
    return {c * offset.x + s * offset.y, c * offset.y - s * offset.x};
}

double level(const PlaneGround& plane, glm::dvec2 from_point) {
    return f64::plane_level(plane.level_m, plane.slope, from_point);
}

double level(const BowlGround& bowl, glm::dvec2 from_centre) {
    return f64::bowl_level(bowl.depth_m, glm::dot(from_centre, from_centre) / (bowl.radius_m * bowl.radius_m));
}

double relief(const ConeGround& cone, glm::dvec2 from_axis) {
    return cone.height_m * f64::cone_relief(glm::length(from_axis), cone.toe_radius_m, cone.crest_radius_m);
}

double relief(const BumpGround& bump, glm::dvec2 from_centre) {
    const glm::dvec2 p = turned(from_centre, bump.direction_deg) / bump.half_width_m;
    const double q = glm::dot(p, p);
    return bump.height_m * (bump.profile == BumpProfile::parabolic ? f64::parabola_relief(q) : f64::gaussian_relief(q));
}

double relief(const BeachGround& beach, glm::dvec2 from_toe) {
    return f64::beach_relief(beach.slope, turned(from_toe, beach.direction_deg).x);
}

double relief(const StepGround& step, glm::dvec2 from_edge) {
    return step.height_m * f64::step_relief(turned(from_edge, step.direction_deg).x);
}

double relief(const BlockGround& block, glm::dvec2 from_centre) {
    return block.height_m * f64::block_relief(turned(from_centre, block.direction_deg), block.size_m / 2.0);
}

template <class Shape>
concept HasLevel = requires(const Shape& shape) {
    level(shape, glm::dvec2());
};

double combined(Combine combine, double so_far_m, double level_m, double added_m) {
    if (combine == Combine::add) return so_far_m + added_m;
    return combine == Combine::max ? std::max(so_far_m, level_m) : std::min(so_far_m, level_m);
}

/// Checks the numbers of one shape, which its messages name.
struct Checker {
    const char* shape;

    void number(const char* key, double value) const {
        require(std::isfinite(value), fmt::format("{} must be a finite number, found {}", key, value));
    }
    void number(const char* key, glm::dvec2 value) const {
        number(key, value.x);
        number(key, value.y);
    }
    void above_0(const char* key, double value) const {
        require(value > 0 && std::isfinite(value), fmt::format("{} must be above 0, found {}", key, value));
    }
    void require(bool holds, const std::string& what) const {
        if (!holds) throw InputError(fmt::format("{}: {}", shape, what));
    }
};

void check(const PlaneGround& plane) {
    const Checker must{"plane"};
    must.number("at_m", plane.at_m);
    must.number("slope", plane.slope);
    must.number("level_m", plane.level_m);
}

void check(const BowlGround& bowl) {
    const Checker must{"bowl"};
    must.number("at_m", bowl.at_m);
    must.above_0("radius_m", bowl.radius_m);
    must.number("depth_m", bowl.depth_m);
}

void check(const ConeGround& cone) {
    const Checker must{"cone"};
    must.number("at_m", cone.at_m);
    must.above_0("toe_radius_m", cone.toe_radius_m);
    must.require(cone.crest_radius_m >= 0 && cone.crest_radius_m <= cone.toe_radius_m,
                 fmt::format("crest_radius_m must be in [0, toe_radius_m = {}], found {}", cone.toe_radius_m,
                             cone.crest_radius_m));
    must.number("height_m", cone.height_m);
}

void check(const BumpGround& bump) {
    const Checker must{"bump"};
    must.number("at_m", bump.at_m);
    for (const double width : {bump.half_width_m.x, bump.half_width_m.y}) {
        must.require(width > 0, fmt::format("half_width_m must be above 0 or infinite, found {}", width));
    }
    must.number("direction_deg", bump.direction_deg);
    must.number("height_m", bump.height_m);
}

void check(const BeachGround& beach) {
    const Checker must{"beach"};
    must.number("at_m", beach.at_m);
    must.number("direction_deg", beach.direction_deg);
    must.number("slope", beach.slope);
}

void check(const StepGround& step) {
    const Checker must{"step"};
    must.number("at_m", step.at_m);
    must.number("direction_deg", step.direction_deg);
    must.number("height_m", step.height_m);
}

void check(const BlockGround& block) {
    const Checker must{"block"};
    must.number("at_m", block.at_m);
    must.above_0("size_m", block.size_m.x);
    must.above_0("size_m", block.size_m.y);
    must.number("direction_deg", block.direction_deg);
    must.number("height_m", block.height_m);
}

void require_finite(const Field<double>& heights, const Grid& grid) {
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            if (std::isfinite(heights(i, j))) continue;
            throw InputError(fmt::format("the ground at ({:g}, {:g}) m must be a finite height, found {}", grid.x_m(i),
                                         grid.y_m(j), heights(i, j)));
        }
    }
}

}  // namespace

void require_valid(const GroundShape& shape) {
    std::visit([](const auto& ground) { check(ground); }, shape.ground);
    if (shape.base_m) Checker{"ground"}.number("base_m", *shape.base_m);
}

double ground_with(const GroundShape& shape, glm::dvec2 at_m, double so_far_m, double depth_m) {
    const auto height = [&](const auto& ground) {
        if constexpr (HasLevel<std::decay_t<decltype(ground)>>) {
            const double level_m = level(ground, at_m - ground.at_m);
            return combined(shape.combine, so_far_m, level_m, level_m);
        } else {
            const double relief_m = relief(ground, at_m - ground.at_m);
            if (relief_m == 0) return so_far_m;
            return combined(shape.combine, so_far_m, shape.base_m.value_or(-depth_m) + relief_m, relief_m);
        }
    };
    return std::visit(height, shape.ground);
}

Field<double> ground_heights(const Bathymetry& bathymetry, const Grid& grid) {
    if (!std::isfinite(bathymetry.depth_m)) {
        throw InputError(fmt::format("the ground: depth_m must be a finite number, found {}", bathymetry.depth_m));
    }
    for (const GroundShape& shape : bathymetry.shapes) require_valid(shape);
    Field<double> heights(grid.nx, grid.ny);
    heights.fill(-bathymetry.depth_m);
    if (bathymetry.file) heights = read_ground(*bathymetry.file, grid);
    for (const GroundShape& shape : bathymetry.shapes) {
        for (int j = 0; j < grid.ny; ++j) {
            for (int i = 0; i < grid.nx; ++i) {
                const glm::dvec2 at_m{grid.x_m(i), grid.y_m(j)};
                heights(i, j) = ground_with(shape, at_m, heights(i, j), bathymetry.depth_m);
            }
        }
    }
    require_finite(heights, grid);
    return heights;
}

}  // namespace waterlight
