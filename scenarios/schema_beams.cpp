#include "scenarios/schema_beams.hpp"

#include "caustics/water_types.hpp"
#include "scenarios/schema_parts.hpp"

namespace waterlight {

using namespace schema;

namespace {

constexpr Range counts{.low = 1, .high = 1 << 14};

/// A kind of water sets what the keys after it may then set otherwise.
Choice water_type(WaterOptics& o) {
    std::vector<std::string_view> names{"none"};
    for (const WaterType& type : water_types) names.push_back(type.name);
    return {std::move(names), 0, [&o](int i) {
                if (i == 0) return;
                const WaterType& type = water_types[static_cast<std::size_t>(i - 1)];
                o.absorption_per_m = type.absorption_per_m;
                o.scattering_per_m = type.scattering_per_m;
                o.phase = type.phase;
            }};
}

void describe_phase(Visitor& v, Phase& p) {
    v.value({"type", "", "Model of the phase function; fournier-forand is of particles, pure-water of water alone."},
            choice(p.type, {"henyey-greenstein", "fournier-forand", "pure-water"}));
    v.value({"g",
             "",
             "Mean cosine of henyey-greenstein.",
             {.low = -1, .high = 1, .excludes_low = true, .excludes_high = true}},
            &p.g);
    v.value({"index",
             "",
             "Refractive index of the particles relative to the water, of fournier-forand.",
             {.low = 1, .high = 1.35, .excludes_low = true}},
            &p.index);
    v.value({"slope",
             "",
             "Slope of the particles' sizes, of fournier-forand.",
             {.low = 3, .high = 5, .excludes_low = true, .excludes_high = true}},
            &p.slope);
}

void describe_reflected(Visitor& v, ReflectedSection& s) {
    v.value({"height_m", "m", "Height above still water at which they end.", positive, true}, &s.height_m);
    v.value({"absorption_per_m", "1/m", "Absorption coefficient of the air.", not_negative}, &s.absorption_per_m);
    v.value({"scattering_per_m", "1/m",
             "Scattering coefficient of the air; the default is that of a visual range of "
             "some 40 km.",
             not_negative},
            &s.scattering_per_m);
    v.section({"phase", "", "Where the air scatters light to."}, [&s](Visitor& in) { describe_phase(in, s.phase); });
}

}  // namespace

void describe_optics(Visitor& v, WaterOptics& o) {
    v.value(
        {"type", "",
         "Water whose absorption, scattering and phase function, measured at 514 nm (Petzold 1972, Mobley 1994), hold "
         "where the keys below do not say otherwise."},
        water_type(o));
    v.value({"absorption_per_m", "1/m", "Absorption coefficient a.", not_negative}, &o.absorption_per_m);
    v.value({"scattering_per_m", "1/m", "Scattering coefficient b; the floor sees unscattered light.", not_negative},
            &o.scattering_per_m);
    v.section({"phase", "", "Where scattered light goes."}, [&o](Visitor& in) { describe_phase(in, o.phase); });
}

void describe_beams(Visitor& v, BeamsSection& s) {
    v.value({"grid", "", "Cells of the grid projected from the sun, each of two beams.", counts, false, "auto"},
            &s.grid);
    v.value({"centre_m", "m", "Centre of the grid on still water; with size_m.", {}, false, "the domain's"},
            &s.centre_m);
    v.value({"size_m", "m", "Size of the grid on still water.", positive, false, "all that lights the domain"},
            &s.size_m);
    v.value({"volume_cells", "", "Cells of the fields of irradiance in the water along x, y and z.", counts, false,
             "no fields"},
            &s.volume_cells);
    v.value({"refine_below",
             "",
             "For pictures, a grid twice as fine where beams shrink to less than this share of their section.",
             {.low = 0, .high = 1, .excludes_low = true, .excludes_high = true},
             false,
             "one grid"},
            &s.refine_below);
    v.optional_section({"reflected", "", "Beams of reflected light above the water; a camera above it sees these."},
                       into(s.reflected, describe_reflected));
}

void describe_camera(Visitor& v, CameraSection& s) {
    v.value({"position_m",
             "m",
             "Place of the camera, z up from still water: in the water, or beside a wall, and above the ground; or in "
             "the air over it, with output.image or caustics.beams.reflected.",
             {},
             true},
            &s.camera.position_m);
    v.value({"target_m", "m", "Place in the middle of the picture.", {}, true}, &s.camera.target_m);
    v.value({"fov_deg",
             "deg",
             "Angle between the lower and the upper edge.",
             {.low = 0, .high = 180, .excludes_low = true, .excludes_high = true}},
            &s.camera.fov_deg);
    v.value({"pixels", "", "Width and height of the picture.", counts}, &s.camera.size);
    v.value({"samples", "", "Sections of a ray's way through a beam.", {.low = 1, .high = 1024}}, &s.samples);
    v.value(
        {"reduction",
         "",
         "Of the scattered light, draws one ray of so many each way and enlarges the picture, with the water's edges "
         "sharp.",
         {.low = 1, .high = 16}},
        &s.reduction);
    v.value({"range_m", "m", "How far it sees scattered light; to there periodic sides repeat.", positive, false,
             "where a thousandth of the light is left, at most twice the domain"},
            &s.range_m);
    v.value({"radiance_max", "W/(m2 sr)", "Radiance at the bright end of the pictures' colours.", positive, false,
             "the largest so far"},
            &s.radiance_max);
    v.value({"radiance_decades",
             "",
             "Decades below radiance_max that the pictures show, on a logarithmic scale.",
             {.low = 0.5, .high = 12},
             false,
             "a linear scale from 0"},
            &s.radiance_decades);
}

}  // namespace waterlight
