// Closed surfaces of triangles from files.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "caustics/objects/object.hpp"

namespace waterlight {

/// The surface in an .obj, .ply or .stl, its lengths times `scale`: polygons as triangles, corners at one place as one.
/// `smooth`: with normals that are the means of those of the triangles around a corner, weighted by area; else facets
/// are flat. What else the file says (colours, textures, normals) is not read. Throws InputError naming the file where
/// it is missing, has another ending, is not what its ending says, names corners that it does not have, or has no
/// triangle. Whether the surface is closed is for validate() to say.
Mesh read_mesh(const std::filesystem::path& file, double scale = 1, bool smooth = false);

/// Faces of three corners or more, one after the other, each corner named from 0.
struct Polygons {
    std::vector<glm::dvec3> corners;
    std::vector<int> named;         ///< by all faces
    std::vector<std::size_t> ends;  ///< of each face in `named`
};

/// Of a face: the time to cut it into triangles grows with their square.
inline constexpr int most_corners = 10000;

/// Each throws InputError naming the file, and in a text the line, where the bytes are not those of its format, or
/// faces name corners that are not there. Corners of an .stl come once for each triangle.
Polygons read_obj(const std::filesystem::path& file, std::string_view text);
Polygons read_ply(const std::filesystem::path& file, std::string_view bytes);
Polygons read_stl(const std::filesystem::path& file, std::string_view bytes);

}  // namespace waterlight
