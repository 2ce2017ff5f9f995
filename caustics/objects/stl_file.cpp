// Triangles of an .stl, as text or binary. VTK's reader (9.1) judges which of the two by the characters of its
// beginning, and trusts the number of triangles that a binary one claims.
#include <array>
#include <bit>
#include <cstdint>

#include "caustics/objects/mesh_file.hpp"
#include "caustics/objects/mesh_text.hpp"
#include "sim/message.hpp"

namespace waterlight {

namespace {

constexpr std::size_t header_bytes = 84;    // a comment of 80, and the number of triangles
constexpr std::size_t triangle_bytes = 50;  // normal and three corners of 12, and 2 of attributes

template <class Number>
Number little_endian(std::string_view bytes, std::size_t at) {
    std::array<char, sizeof(Number)> raw;
    std::ranges::copy(bytes.substr(at, raw.size()), raw.begin());
    if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(raw);
    return std::bit_cast<Number>(raw);
}

void add_triangle(Polygons& polygons) {
    const int end = static_cast<int>(polygons.corners.size());
    for (int k = end - 3; k < end; ++k) polygons.named.push_back(k);
    polygons.ends.push_back(polygons.named.size());
}

Polygons read_binary(const std::filesystem::path& file, std::string_view bytes) {
    if (bytes.size() < header_bytes)
        reject_mesh(file, "is no .stl: text begins with \"solid\", and binary has 84 bytes");
    const std::size_t triangles = little_endian<std::uint32_t>(bytes, header_bytes - 4);
    if ((bytes.size() - header_bytes) / triangle_bytes < triangles)
        reject_mesh(file, fmt::format("claims {} triangles, more than its {} bytes can hold", triangles, bytes.size()));
    Polygons polygons;
    for (std::size_t t = 0; t < triangles; ++t) {
        for (std::size_t k = 1; k <= 3; ++k) {
            const std::size_t at = header_bytes + t * triangle_bytes + 12 * k;
            polygons.corners.emplace_back(little_endian<float>(bytes, at), little_endian<float>(bytes, at + 4),
                                          little_endian<float>(bytes, at + 8));
        }
        add_triangle(polygons);
    }
    return polygons;
}

enum class Within { nothing, solid, facet, loop, full_loop, closed_loop };

struct Step {
    Within from;
    std::string_view word;
    Within to;
};

constexpr Step steps[]{
    {Within::nothing, "solid", Within::solid},       {Within::solid, "facet", Within::facet},
    {Within::solid, "endsolid", Within::nothing},    {Within::facet, "outer", Within::loop},
    {Within::loop, "vertex", Within::loop},          {Within::full_loop, "endloop", Within::closed_loop},
    {Within::closed_loop, "endfacet", Within::solid}};

std::string lower(std::string_view word) {
    std::string small(word);
    for (char& c : small)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return small;
}

/// Corners are floats, as in binary files: those that differ by less are one.
Polygons read_text(const std::filesystem::path& file, std::string_view text) {
    Polygons polygons;
    MeshLines lines(file, text);
    Within within = Within::nothing;
    while (!lines.at_end()) {
        std::string_view line = lines.next();
        const std::string word = lower(take_word(line));
        if (word.empty()) continue;
        const auto step =
            std::ranges::find_if(steps, [&](const Step& s) { return s.from == within && s.word == word; });
        if (step == std::end(steps))
            lines.reject(fmt::format("\"{}\" cannot stand here in an .stl", shortened(in_one_line(word), 60)));
        within = step->to;
        if (word == "vertex") {
            polygons.corners.emplace_back(glm::vec3(lines.take_point(line)));
            if (polygons.corners.size() % 3 == 0) within = Within::full_loop;
        }
        if (word == "endloop") add_triangle(polygons);
    }
    if (within != Within::nothing) reject_mesh(file, "is cut short: it does not end with \"endsolid\"");
    return polygons;
}

}  // namespace

Polygons read_stl(const std::filesystem::path& file, std::string_view bytes) {
    std::string_view begin = bytes.substr(0, header_bytes);
    const bool says_text = lower(take_word(begin)) == "solid";
    // Some binary files begin with "solid" too.
    const bool is_binary =
        bytes.size() >= header_bytes && (bytes.size() - header_bytes) % triangle_bytes == 0 &&
        (bytes.size() - header_bytes) / triangle_bytes == little_endian<std::uint32_t>(bytes, header_bytes - 4);
    return says_text && !is_binary ? read_text(file, bytes) : read_binary(file, bytes);
}

}  // namespace waterlight
