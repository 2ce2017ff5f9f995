// The ground under the water.
#include <glm/vec2.hpp>

#include "scenarios/schema_parts.hpp"
#include "scenarios/schema_shallow.hpp"

namespace waterlight::schema {

namespace {

constexpr std::string_view uphill = "Counter-clockwise from +x.";

void describe_plane(Visitor& v, PlaneGround& s) {
    v.value({"at_m", "m", "A point of it."}, &s.at_m);
    v.value({"slope", "", "Rise per metre along x and y.", {}, true}, &s.slope);
    v.value({"level_m", "m", "Height at the point, above still water."}, &s.level_m);
}

void describe_bowl(Visitor& v, BowlGround& s) {
    v.value({"at_m", "m", "Its centre.", {}, true}, &s.at_m);
    v.value({"radius_m", "m", "Of its shore at still water.", positive}, &s.radius_m);
    v.value({"bowl_depth_m", "m", "Depth of its centre below still water."}, &s.depth_m);
}

void describe_cone(Visitor& v, ConeGround& s) {
    v.value({"at_m", "m", "Its centre.", {}, true}, &s.at_m);
    v.value({"toe_radius_m", "m", "Radius at its base.", positive}, &s.toe_radius_m);
    v.value({"crest_radius_m", "m", "Radius at its crest, at most that of the toe.", not_negative}, &s.crest_radius_m);
    v.value({"height_m", "m", "Of the crest above the base."}, &s.height_m);
}

void describe_bump_ground(Visitor& v, BumpGround& s) {
    v.value({"at_m", "m", "Its centre.", {}, true}, &s.at_m);
    v.value({"half_width_m", "m", "Along the direction and across it.", positive}, &s.half_width_m);
    v.value({"direction_deg", "deg", uphill, circle}, &s.direction_deg);
    v.value({"height_m", "m", "Of the top above the base."}, &s.height_m);
    v.value({"profile", "", "height (1 - q) or height exp(-q), q the squared distance in half widths."},
            choice(s.profile, {"parabolic", "gaussian"}));
}

void describe_beach(Visitor& v, BeachGround& s) {
    v.value({"at_m", "m", "A point of the line where it begins.", {}, true}, &s.at_m);
    v.value({"direction_deg", "deg", "Uphill, counter-clockwise from +x.", circle}, &s.direction_deg);
    v.value({"slope", "", "Rise per metre; negative falls."}, &s.slope);
}

void describe_step(Visitor& v, StepGround& s) {
    v.value({"at_m", "m", "A point of its edge.", {}, true}, &s.at_m);
    v.value({"direction_deg", "deg", "To the side of the step, counter-clockwise from +x.", circle}, &s.direction_deg);
    v.value({"height_m", "m", "Above the base."}, &s.height_m);
}

void describe_block(Visitor& v, BlockGround& s) {
    v.value({"at_m", "m", "Its centre.", {}, true}, &s.at_m);
    v.value({"size_m", "m", "Lengths of its sides.", positive, true}, &s.size_m);
    v.value({"direction_deg", "deg", "Of its first side, counter-clockwise from +x.", circle}, &s.direction_deg);
    v.value({"height_m", "m", "Above the base."}, &s.height_m);
}

/// Plane and bowl have levels of their own, the others a base.
template <class Shape, class Describe>
Visitor::Inside append_shape(std::vector<GroundShape>& shapes, bool has_base, Describe describe_one) {
    return [&shapes, has_base, describe_one](Visitor& v) {
        Shape own;
        GroundShape shape;
        describe_one(v, own);
        v.value({"combine", "", "With the ground so far: the higher of both, the lower, or laid on it."},
                choice(shape.combine, {"max", "min", "add"}));
        if (has_base)
            v.value({"base_m", "m", "Height on which it stands, above still water.", {}, false, "the flat floor's"},
                    &shape.base_m);
        shape.ground = own;
        shapes.push_back(shape);
    };
}

void describe_survey(Visitor& v, GroundFile& s) {
    v.value({"array", "", "Of a .vti."}, &s.array);
    v.value({"positive", "", "Whether the file's numbers are heights or depths."},
            choice_or("auto", s.positive, {"up", "down"}));
    v.value({"datum_m", "m", "Height of still water in the file's own datum."}, &s.datum_m);
    v.value({"offset_m", "m", "Where the file's origin lies in the domain."}, &s.offset_m);
    v.value({"outside", "", "Cells without data: refused, or given the value of the nearest data."},
            choice(s.outside, {"refuse", "extend"}));
}

}  // namespace

void describe_ground(Visitor& v, DomainSection& s) {
    v.value({"bathymetry",
             "",
             "File of the ground in place of the flat floor: .vti, .asc (ESRI ASCII grid), .xyz, .txt, .csv or .dat "
             "(lines of x y z on a lattice); beside the scenario or below $WATERLIGHT_DATA; model shallow-water, or "
             "prescribed for the beams of light alone.",
             {},
             false,
             "none"},
            &s.bathymetry);
    v.section({"survey", "", "How the file of bathymetry is meant."},
              [&s](Visitor& in) { describe_survey(in, s.survey); });
    std::vector<GroundShape>& g = s.ground;
    v.list({"ground", "", "A shape of the ground, laid on the floor or the file in turn; models as of bathymetry."},
           {{"plane", "A plane, everywhere.", append_shape<PlaneGround>(g, false, describe_plane)},
            {"bowl", "A paraboloid, everywhere.", append_shape<BowlGround>(g, false, describe_bowl)},
            {"cone", "A cone cut off at its crest: an island.", append_shape<ConeGround>(g, true, describe_cone)},
            {"bump", "A hump or, with a negative height, a hollow.",
             append_shape<BumpGround>(g, true, describe_bump_ground)},
            {"beach", "Flat up to a line, then rising.", append_shape<BeachGround>(g, true, describe_beach)},
            {"step", "A half plane: a step or a cliff.", append_shape<StepGround>(g, true, describe_step)},
            {"block", "A box.", append_shape<BlockGround>(g, true, describe_block)}});
}

}  // namespace waterlight::schema
