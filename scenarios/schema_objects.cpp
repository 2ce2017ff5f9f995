#include "scenarios/schema_objects.hpp"

#include "scenarios/schema_parts.hpp"

namespace waterlight {

using namespace schema;

namespace {

void describe_material(Visitor& v, Material& m) {
    v.value({"type", "",
             "diffuse: opaque, where light ends; mirror: opaque, sends light on; glass: clear, refracts and reflects."},
            choice(m.type, {material_names.begin(), material_names.end()}));
    v.value({"reflectance", "", "Part of the light that diffuse and mirror send back.", fractions}, &m.reflectance);
    v.value({"index", "", "Refractive index of glass at 587.6 nm; that of air is 1.", {.low = 1, .high = 4}}, &m.index);
    v.value({"abbe_number", "", "Of glass, by which its index depends on the wavelength of light in colour.", positive,
             false, "the same index for all colours"},
            &m.abbe_number);
    v.value({"absorption_per_m", "1/m", "Absorption coefficient within glass.", not_negative}, &m.absorption_per_m);
}

void describe_path_point(Visitor& v, PathPoint& p) {
    v.value({"time_s", "s", "When it is there; later than the point before.", {}, true}, &p.time_s);
    v.value({"centre_m", "m", "Where the shape's origin is then.", {}, true}, &p.centre_m);
}

void describe_place(Visitor& v, Object& o) {
    v.value({"name", "", "Its name in the report; no other object's.", {}, true}, &o.name);
    v.value({"centre_m", "m", "Where the shape's origin is, z above still water; or a path.", {}, false, "of the path"},
            &o.centre_m);
    v.value({"rotation_deg", "deg", "About x, then y, then z; counter-clockwise.", circle}, &o.rotation_deg);
    v.list({"path", "", "Places on its way, instead of centre_m: straight between them, still before and after."},
           {{"", "", append<PathPoint>(o.path, describe_path_point)}});
    v.section({"material", "", "What the object is made of."},
              [&o](Visitor& in) { describe_material(in, o.material); });
}

void describe_sphere(Visitor& v, Sphere& s) {
    v.value({"radius_m", "m", "Its radius; the origin is its centre.", positive}, &s.radius_m);
}

void describe_box(Visitor& v, Box& s) {
    v.value({"size_m", "m", "Lengths of its sides along x, y and z; the origin is its centre.", positive}, &s.size_m);
}

void describe_ring(Visitor& v, Ring& s) {
    v.value({"inner_radius_m", "m", "Radius of its hole.", positive}, &s.inner_radius_m);
    v.value({"outer_radius_m", "m", "Its outer radius, above the inner one.", positive}, &s.outer_radius_m);
    v.value({"height_m", "m", "Its height; the origin is in the middle.", positive}, &s.height_m);
}

void describe_cup(Visitor& v, Cup& s) {
    v.value({"bottom_radius_m", "m", "Outer radius at the bottom.", positive}, &s.bottom_radius_m);
    v.value({"top_radius_m", "m", "Outer radius at the rim.", positive}, &s.top_radius_m);
    v.value({"height_m", "m", "Its height; the origin is the middle of its underside.", positive}, &s.height_m);
    v.value({"wall_m", "m", "Thickness of the wall, measured level; below both radii.", positive}, &s.wall_m);
    v.value({"base_m", "m", "Thickness of the base, below the height.", positive}, &s.base_m);
}

/// One shape of [[object]], appended; `describe_shape` has its own keys.
template <class Described, class Describe>
Visitor::Inside append_object(std::vector<ObjectSection>& objects, Describe describe_shape) {
    return [&objects, describe_shape](Visitor& v) {
        ObjectSection section;
        Described shape;
        describe_place(v, section.object);
        describe_shape(v, shape);
        section.object.shape = shape;
        objects.push_back(std::move(section));
    };
}

Visitor::Inside append_mesh(std::vector<ObjectSection>& objects) {
    return [&objects](Visitor& v) {
        ObjectSection section;
        section.object.shape = Mesh{};
        describe_place(v, section.object);
        std::string file;
        v.value({"file",
                 "",
                 "A closed surface: .obj, .ply or .stl; beside the scenario or below $WATERLIGHT_DATA.",
                 {},
                 true},
                &file);
        v.value({"scale", "", "Metres per unit of that file.", positive}, &section.file_scale);
        v.value({"smooth", "", "Whether normals vary over its triangles, else these are flat."}, &section.smooth);
        section.file = file;
        objects.push_back(std::move(section));
    };
}

enum class LightType { sun, point, spot };

void describe_splat(Visitor& v, SplatOptions& s) {
    v.value({"grid", "", "Vertices along the longer axis of the domain.", {.low = 2, .high = 16384}}, &s.grid);
    v.value({"iterations", "", "Of the landing in the light's image.", {.low = 1, .high = 1000}}, &s.iterations);
    v.value(
        {"landing", "",
         "What a step of the landing goes by: height, to where the ray is as high as the receiver seen; distance, as "
         "far as it, as in Shah et al., which diverges under a low sun."},
        choice(s.landing, {"height", "distance"}));
    v.value({"size", "",
             "Of the Gaussian that a vertex lights: jacobian, that of its own footprint; fixed, radius_pixels for all, "
             "as in Shah et al."},
            choice(s.size, {"jacobian", "fixed"}));
    v.value({"radius_pixels", "", "Standard deviation of a fixed splat.", positive}, &s.radius_pixels);
    v.value(
        {"bounces", "", "Interfaces that a vertex's light may meet where there are objects.", {.low = 1, .high = 1000}},
        &s.bounces);
}

void describe_photons(Visitor& v, PhotonOptions& s) {
    v.value(
        {"start", "",
         "Where photons start: light, on the light's image of the scene; surface, on the water, where the sun meets "
         "no object before it; auto takes surface where it may."},
        choice(s.start, {"auto", "light", "surface"}));
    v.value({"branching", "",
             "What becomes of a photon at an interface: roulette, one way, drawn by its share; split, both, as long as "
             "they carry a thousandth of it."},
            choice(s.branching, {"roulette", "split"}));
    v.value({"map", "", "Photons of a pass along each axis of where they start.", {.low = 1, .high = 65536}}, &s.map);
    v.value({"passes", "", "Passes at most, each of other photons.", {.low = 1, .high = 1 << 20}}, &s.passes);
    v.value({"bounces",
             "",
             "Interfaces that a photon meets at most, the water's and both sides of every wall of glass; what then "
             "still travels is lost.",
             {.low = 1, .high = 10000}},
            &s.bounces);
    v.value({"tolerance", "", "Relative error by the map's own estimate at which passes end; 0: after all of them.",
             not_negative},
            &s.tolerance);
    v.value({"blur_pixels",
             "",
             "Standard deviation of the Gaussian that smooths the map; 0: none.",
             {.low = 0, .high = 100}},
            &s.blur_pixels);
    v.value({"seed", "", "Seed of the photons."}, &s.seed);
}

}  // namespace

void describe_objects(Visitor& v, std::vector<ObjectSection>& s) {
    const auto& [sphere, box, ring, cup, mesh] = shape_names;
    v.list({"object", "", "A thing in or above the water: it stops light, or sends it on, as docs/objects.md says."},
           {{sphere, "A sphere.", append_object<Sphere>(s, describe_sphere)},
            {box, "A box.", append_object<Box>(s, describe_box)},
            {ring, "A tube with a rectangular section, its axis along z.", append_object<Ring>(s, describe_ring)},
            {cup, "A beaker, open at the top.", append_object<Cup>(s, describe_cup)},
            {mesh, "A closed surface of triangles from a file.", append_mesh(s)}});
}

void describe_lamp(Visitor& v, std::optional<Lamp>& lamp) {
    LightType type = LightType::sun;
    Lamp stated;
    v.value({"type", "",
             "sun: parallel light; point: a lamp that sends light to all sides; spot: one that lights a cone. Lamps "
             "need caustics.floor.method splat or photons."},
            choice(type, {"sun", "point", "spot"}));
    v.value({"at_m", "m", "Place of a lamp, z above still water.", {}, false, "required of point and spot"},
            &stated.at_m);
    v.value({"intensity_w_sr", "W/sr", "Of a lamp, to each side that it lights.", not_negative},
            &stated.intensity_w_sr);
    v.value({"towards_m", "m", "A place on the axis of a spot.", {}, false, "required of spot"}, &stated.towards_m);
    v.value({"half_angle_deg",
             "deg",
             "Of the cone of a spot; its edge is sharp.",
             {.low = 0, .high = 90, .excludes_low = true, .excludes_high = true}},
            &stated.half_angle_deg);
    if (type == LightType::sun) return;
    stated.type = type == LightType::point ? Lamp::Type::point : Lamp::Type::spot;
    lamp = stated;
}

void describe_methods(Visitor& v, FloorSection& s) {
    v.section(
        {"splat", "", "Of method splat: a grid of vertices as the light sees them, each splatted where it lands."},
        [&s](Visitor& in) { describe_splat(in, s.splat); });
    v.section({"photons", "", "Of method photons: light in portions, followed through water and objects."},
              [&s](Visitor& in) { describe_photons(in, s.photons); });
}

}  // namespace waterlight
