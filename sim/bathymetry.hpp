// The ground under the water: heights in metres above the still level 0, so z = -depth where there is water.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <variant>
#include <vector>

#include "sim/bathymetry_file.hpp"
#include "sim/field.hpp"
#include "sim/grid.hpp"

namespace waterlight {

/// A plane of a given height at a point.
struct PlaneGround {
    glm::dvec2 at_m{0, 0};
    glm::dvec2 slope{0, 0};  ///< rise per metre along x and y
    double level_m = 0;      ///< height at the point, above the still level
};

/// A paraboloid, depth_m (1 - r^2 / radius_m^2) below the still level, and rising on beyond the radius.
struct BowlGround {
    glm::dvec2 at_m{0, 0};
    double radius_m = 1;  ///< of the shore, > 0
    double depth_m = 1;   ///< at the centre
};

/// A cone, cut off at its crest: an island.
struct ConeGround {
    glm::dvec2 at_m{0, 0};
    double toe_radius_m = 1;    ///< > 0
    double crest_radius_m = 0;  ///< in [0, toe_radius_m]
    double height_m = 1;        ///< of the crest above the base
};

enum class BumpProfile { parabolic, gaussian };

/// A hump of height (1 - q) or height exp(-q), q = (along / half_width.x)^2 + (across / half_width.y)^2.
struct BumpGround {
    glm::dvec2 at_m{0, 0};
    glm::dvec2 half_width_m{1, 1};  ///< along the direction and across it, > 0; infinity makes a ridge
    double direction_deg = 0;       ///< counter-clockwise from +x
    double height_m = 1;
    BumpProfile profile = BumpProfile::parabolic;
};

/// Flat up to a straight toe line, then rising.
struct BeachGround {
    glm::dvec2 at_m{0, 0};     ///< a point of the toe line
    double direction_deg = 0;  ///< uphill, counter-clockwise from +x
    double slope = 0.1;        ///< rise per metre; below 0 it falls
};

/// A half plane: a step or a cliff.
struct StepGround {
    glm::dvec2 at_m{0, 0};     ///< a point of the edge
    double direction_deg = 0;  ///< to the side of the step, counter-clockwise from +x
    double height_m = 1;
};

/// A box.
struct BlockGround {
    glm::dvec2 at_m{0, 0};  ///< its centre
    glm::dvec2 size_m{1, 1};
    double direction_deg = 0;  ///< of its first side, counter-clockwise from +x
    double height_m = 1;
};

using Ground = std::variant<PlaneGround, BowlGround, ConeGround, BumpGround, BeachGround, StepGround, BlockGround>;

/// What becomes of the ground so far where a shape is: the higher of both (it rises out of it), the lower (it is dug),
/// or the ground with the shape's relief laid on it.
enum class Combine { max, min, add };

/// A shape and its place in the whole. Plane and bowl are everywhere and have levels of their own, which `add` adds.
/// The others stand on base_m and are only where their relief is not 0, whatever the ground is elsewhere.
struct GroundShape {
    Ground ground;
    Combine combine = Combine::max;
    std::optional<double> base_m = std::nullopt;  ///< height above the still level; none: that of the flat floor
};

/// The whole ground: flat at -depth_m or read from a file, and then the shapes in their order.
struct Bathymetry {
    double depth_m = 1;              ///< of the flat floor, any number
    std::optional<GroundFile> file;  ///< takes the place of the flat floor
    std::vector<GroundShape> shapes;
};

/// Throws InputError "SHAPE: KEY must ..., found ..." where a number of a shape is out of its range.
void require_valid(const GroundShape& shape);

/// The height (m) at a place of ground whose height there was `so_far_m` before the shape; depth_m is that of the flat
/// floor. The shape is valid.
double ground_with(const GroundShape& shape, glm::dvec2 at_m, double so_far_m, double depth_m);

/// Heights (m) of the ground: shapes at the cell centres, a file as read_ground() resamples it. Throws what
/// require_valid() and read_ground() throw, and InputError where a height is not finite.
Field<double> ground_heights(const Bathymetry& bathymetry, const Grid& grid);

}  // namespace waterlight
