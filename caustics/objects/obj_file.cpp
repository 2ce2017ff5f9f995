// Corners and polygons of an .obj. VTK's reader (9.1) writes beyond its arrays where some faces have texture
// coordinates or normals and others do not.
#include <cstdint>

#include "caustics/objects/mesh_file.hpp"
#include "caustics/objects/mesh_text.hpp"

namespace waterlight {

namespace {

struct ObjCounts {
    std::int64_t v = 0, vt = 0, vn = 0;
};

/// The corner, from 0, that "7", "7/3", "7//2" or "7/3/2" names, each from 1 or back from -1; none where one of these
/// is not there.
std::optional<int> corner_of(std::string_view word, const ObjCounts& had) {
    const std::int64_t counts[] = {had.v, had.vt, had.vn};
    std::optional<int> corner;
    for (int part = 0; part < 3; ++part) {
        const std::size_t slash = word.find('/');
        const std::string_view digits = word.substr(0, slash);
        if (!digits.empty() || part != 1) {
            const auto n = number_in<std::int64_t>(digits);
            if (!n || *n == 0 || *n > counts[part] || *n < -counts[part]) return std::nullopt;
            if (part == 0) corner = static_cast<int>(*n > 0 ? *n - 1 : had.v + *n);
        }
        if (slash == std::string_view::npos) return corner;
        word.remove_prefix(slash + 1);
    }
    return std::nullopt;
}

}  // namespace

Polygons read_obj(const std::filesystem::path& file, std::string_view text) {
    if (!is_printable(text)) reject_mesh(file, "is no text, as an .obj is");
    Polygons polygons;
    ObjCounts had;
    for (MeshLines lines(file, text); !lines.at_end();) {
        std::string_view line = lines.next();
        if (!line.empty() && line.back() == '\\') lines.reject("it goes on in the next, which is not read");
        const std::string_view word = take_word(line);
        if (word == "v" || word == "vn") {
            const glm::dvec3 numbers = lines.take_point(line);
            if (word == "v") polygons.corners.push_back(numbers);
            ++(word == "v" ? had.v : had.vn);
        } else if (word == "vt") {
            ++had.vt;
        } else if (word == "f") {
            const std::size_t begin = polygons.named.size();
            for (std::string_view named = take_word(line); !named.empty(); named = take_word(line)) {
                const std::optional<int> corner = corner_of(named, had);
                if (!corner) lines.reject("it names a corner that is not there");
                polygons.named.push_back(*corner);
            }
            const std::size_t end = polygons.named.size();
            if (end - begin < 3) lines.reject("it has fewer than three corners");
            if (end - begin > most_corners) lines.reject(fmt::format("it has more than {} corners", most_corners));
            polygons.ends.push_back(end);
        }
    }
    return polygons;
}

}  // namespace waterlight
