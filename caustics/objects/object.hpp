// Things in or above the water: their shapes, what they are made of, and where they are when.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace waterlight {

/// What an object is made of.
struct Material {
    enum class Type {
        diffuse,  ///< opaque; sends back `reflectance` of what falls on it, evenly. Where light ends
        mirror,   ///< opaque; sends back `reflectance` of it, as a mirror does, and absorbs the rest
        glass     ///< clear; refracts by `index`, reflects by Fresnel's formula
    };
    Type type = Type::diffuse;
    double reflectance = 0.5;             ///< in [0, 1]
    double index = 1.5;                   ///< of glass at 587.6 nm, >= 1; that of air is 1
    std::optional<double> abbe_number{};  ///< of glass, > 0: its dispersion; none: the same index for all colours
    double absorption_per_m = 0;          ///< within glass, >= 0

    /// Index of glass for light of this wavelength, by Cauchy's formula A + B / wavelength^2 through `index` and
    /// `abbe_number` = (n_d - 1) / (n_F - n_C).
    double index_at(double wavelength_nm) const;
};

/// Shapes, each about its own origin, z up, lengths in m.
struct Sphere {
    double radius_m = 0.5;
};
struct Box {
    glm::dvec3 size_m{1, 1, 1};
};
/// A tube with a rectangular section: a napkin ring standing on a table.
struct Ring {
    double inner_radius_m = 0.4, outer_radius_m = 0.5;  ///< inner < outer
    double height_m = 0.2;
};
/// A beaker, open at the top, its walls straight.
struct Cup {
    double bottom_radius_m = 0.3, top_radius_m = 0.4;  ///< outside
    double height_m = 1;
    double wall_m = 0.03;  ///< thickness of the wall, measured level, < both radii
    double base_m = 0.05;  ///< thickness of the base, < height
};
/// A closed surface of triangles, corners counter-clockwise seen from outside.
struct Mesh {
    std::vector<glm::dvec3> corners_m{};
    std::vector<glm::ivec3> triangles{};
    std::vector<glm::dvec3> normals{};  ///< of the corners, for smooth shading; empty: those of the triangles
};

using Shape = std::variant<Sphere, Box, Ring, Cup, Mesh>;

/// A place on an object's path.
struct PathPoint {
    double time_s = 0;
    glm::dvec3 centre_m{0, 0, 0};
};

struct Object {
    std::string name{};
    Shape shape{};
    Material material{};
    glm::dvec3 centre_m{0, 0, 0};      ///< where the shape's origin is, z above still water
    glm::dvec3 rotation_deg{0, 0, 0};  ///< about x, then y, then z; counter-clockwise
    /// Where it is instead of `centre_m`, if not empty: in order of time; straight between, and still before and after.
    std::vector<PathPoint> path{};

    glm::dvec3 centre_at(double time_s) const;
    /// Turns the shape's own directions into the world's.
    glm::dmat3 turn() const;
};

/// Throws InputError where a number is out of its range, a path is not in order of time, or a mesh is not closed, has
/// no triangle, or names a corner that it does not have. The message begins with the object's name.
void validate(const Object& object);

}  // namespace waterlight
