// What VTK's readers of meshes take on trust (9.1), checked before they see it.
#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "caustics/objects/mesh_file.hpp"
#include "caustics/objects/mesh_text.hpp"

namespace waterlight {

namespace {

constexpr std::size_t longest_line = 4000;  // of the readers' buffers
constexpr std::size_t most_corners = 255;   // of a polygon
constexpr std::size_t most_parts = 256;     // of a header; each is compared with all before

// .ply

struct PlyProperty {
    std::size_t count_bytes = 0;  ///< of the number before a list; 0: no list
    std::size_t bytes = 0;
};

struct PlyElement {
    std::string_view name;
    std::uint64_t rows = 0;
    std::vector<PlyProperty> properties;
    std::vector<std::string_view> names;
};

enum class PlyFormat { ascii, little, big };

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
};

std::size_t bytes_of_type(std::string_view type) {
    static const std::map<std::string_view, std::size_t> types{
        {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
        {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
        {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
    const auto found = types.find(type);
    return found == types.end() ? 0 : found->second;
}

bool is_float(std::string_view type) { return type.starts_with("float") || type == "double"; }

class PlyChecker {
  public:
    PlyChecker(const std::filesystem::path& file, std::string_view bytes) : file_(file), rest_(bytes) {}

    void check() {
        read_header();
        require_mesh();
        for (const PlyElement& element : header_.elements)
            for (std::uint64_t row = 0; row < element.rows; ++row)
                header_.format == PlyFormat::ascii ? check_line(element) : check_bytes(element);
    }

  private:
    void require(bool holds, const std::string& otherwise) const {
        if (!holds) reject_mesh(file_, otherwise);
    }

    /// VTK parts words by blanks and tabs alone, and goes astray where another character stands for one.
    std::string_view next_line() {
        const std::string_view line = take_line(rest_);
        require(line.size() <= longest_line, "has a line that is too long");
        require(std::ranges::all_of(line, [](unsigned char c) { return c >= 0x20 || c == '\t'; }),
                "has a control character in its text");
        return line;
    }

    void read_header() {
        require(take_line(rest_) == "ply", "is no .ply: it does not begin with \"ply\"");
        read_format();
        while (true) {
            require(!rest_.empty(), "its header has no end");
            std::string_view line = next_line();
            const std::string_view word = take_word(line);
            if (word == "end_header") return;
            if (word == "element")
                add_element(line);
            else if (word == "property")
                add_property(line);
            else
                require(word == "comment" || word == "obj_info", "its header has an unknown line");
        }
    }

    void read_format() {
        std::string_view line = next_line();
        const std::string_view head = take_word(line), name = take_word(line), version = take_word(line);
        const bool known = name == "ascii" || name == "binary_little_endian" || name == "binary_big_endian";
        require(head == "format" && known && version == "1.0", "has no format that is known");
        header_.format = name == "ascii"                  ? PlyFormat::ascii
                         : name == "binary_little_endian" ? PlyFormat::little
                                                          : PlyFormat::big;
    }

    void add_element(std::string_view line) {
        PlyElement element;
        element.name = take_word(line);
        const auto rows = number_in<std::uint32_t>(take_word(line));
        // Each takes a byte of the file at least.
        require(rows && *rows <= rest_.size(), "claims more elements than its bytes can hold");
        element.rows = *rows;
        require(std::ranges::none_of(header_.elements, [&](const auto& e) { return e.name == element.name; }),
                "has an element twice");
        require(header_.elements.size() < most_parts, "has too many elements");
        header_.elements.push_back(element);
    }

    void add_property(std::string_view line) {
        require(!header_.elements.empty(), "has a property of no element");
        PlyProperty property;
        std::string_view type = take_word(line);
        if (type == "list") {
            const std::string_view count = take_word(line);
            property.count_bytes = bytes_of_type(count);
            require(property.count_bytes > 0 && !is_float(count), "has a list whose length has no type that is known");
            type = take_word(line);
        }
        property.bytes = bytes_of_type(type);
        const std::string_view name = take_word(line);
        require(property.bytes > 0 && !name.empty(), "has a property of no type that is known");
        const bool is_corners = name == "vertex_indices" || name == "vertex_index";
        require(!is_corners || !is_float(type), "names its corners by numbers that are not whole");
        require(std::ranges::find(header_.elements.back().names, name) == header_.elements.back().names.end(),
                "has a property twice");
        require(header_.elements.back().properties.size() < most_parts, "has an element of too many properties");
        header_.elements.back().properties.push_back(property);
        header_.elements.back().names.push_back(name);
    }

    const PlyElement& element(std::string_view name) const {
        const auto found = std::ranges::find(header_.elements, name, &PlyElement::name);
        require(found != header_.elements.end(), fmt::format("has no element \"{}\"", name));
        return *found;
    }

    void require_mesh() const {
        const PlyElement &vertex = element("vertex"), &face = element("face");
        const auto has = [](const PlyElement& in, std::string_view name, bool is_list) {
            const auto found = std::ranges::find(in.names, name);
            if (found == in.names.end()) return false;
            const auto n = static_cast<std::size_t>(found - in.names.begin());
            return (in.properties[n].count_bytes > 0) == is_list;
        };
        for (const std::string_view axis : {"x", "y", "z"})
            require(has(vertex, axis, false), fmt::format("its corners have no {}", axis));
        require(has(face, "vertex_indices", true) || has(face, "vertex_index", true),
                "its faces have no list vertex_indices");
        require(&vertex < &face, "has its faces before its corners");
        for (const PlyElement& e : header_.elements) require(!e.properties.empty(), "has an element of no property");
        // VTK does not pass over the rows of an element that it does not know, and takes them for faces.
        for (const PlyElement* e = header_.elements.data(); e != &face; ++e)
            require(e == &vertex || e->rows == 0, "has other elements before its corners or faces");
    }

    /// Lists of one row, by their names. VTK takes it that corners are there, and have two texture coordinates each.
    struct Row {
        std::uint64_t corners = 0, texture = 0;
        bool has_texture = false;
    };

    static bool names_corners(const PlyElement& element, std::size_t k) {
        return element.name == "face" && (element.names[k] == "vertex_indices" || element.names[k] == "vertex_index");
    }

    void add_list(const PlyElement& element, std::size_t k, std::uint64_t count, Row& row) const {
        require(count <= most_corners, "has a list that is too long");
        if (names_corners(element, k)) row.corners = count;
        if (element.name == "face" && element.names[k] == "texcoord") {
            row.texture = count;
            row.has_texture = true;
        }
    }

    void require_corner(std::optional<std::int64_t> corner) const {
        const auto most = static_cast<std::int64_t>(element("vertex").rows);
        require(corner && *corner >= 0 && *corner < most, fmt::format("names a corner that is none of its {}", most));
    }

    void check_row(const PlyElement& element, const Row& row) const {
        require(!row.has_texture || row.texture == 2 * row.corners,
                "has faces whose texture coordinates are not two a corner");
        if (element.name == "face") require(row.corners >= 3, "has a face of fewer than three corners");
    }

    void check_line(const PlyElement& element) {
        // VTK frees the row before again where a line has no end.
        require(rest_.find('\n') != std::string_view::npos, "is cut short: a row has no end of line");
        std::string_view line = next_line();
        const auto next = [&] {
            const std::string_view word = take_word(line);
            require(decimal_in(word).has_value(), "has no number where one must be");
            return word;
        };
        Row row;
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const std::string_view first = next();
            if (element.properties[p].count_bytes == 0) continue;
            const auto count = number_in<std::uint64_t>(first);
            require(count.has_value(), "has a list whose length is no whole number");
            add_list(element, p, *count, row);
            for (std::uint64_t k = 0; k < *count; ++k) {
                const std::string_view word = next();
                if (names_corners(element, p)) require_corner(number_in<std::int64_t>(word));
            }
        }
        check_row(element, row);
    }

    void check_bytes(const PlyElement& element) {
        Row row;
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            if (property.count_bytes == 0) {
                skip(property.bytes);
                continue;
            }
            const std::uint64_t count = take_whole(property.count_bytes);
            add_list(element, p, count, row);
            for (std::uint64_t k = 0; k < count; ++k) {
                if (names_corners(element, p))
                    require_corner(static_cast<std::int64_t>(take_whole(property.bytes)));
                else
                    skip(property.bytes);
            }
        }
        check_row(element, row);
    }

    void skip(std::uint64_t bytes) {
        require(bytes <= rest_.size(), "is cut short");
        rest_.remove_prefix(bytes);
    }

    /// A whole number without a sign: one below 0 becomes one beyond all corners.
    std::uint64_t take_whole(std::size_t bytes) {
        require(bytes <= rest_.size(), "is cut short");
        std::uint64_t count = 0;
        for (std::size_t k = 0; k < bytes; ++k) {
            const auto byte = static_cast<unsigned char>(rest_[k]);
            count |= static_cast<std::uint64_t>(byte) << (8 * (header_.format == PlyFormat::big ? bytes - 1 - k : k));
        }
        rest_.remove_prefix(bytes);
        return count;
    }

    const std::filesystem::path& file_;
    std::string_view rest_;
    PlyHeader header_;
};

/// vtksys::SystemTools::DetectFileType(): by the first 256 bytes, of which one in twenty may be others than these.
bool is_text_to_vtk(std::string_view bytes) {
    const std::string_view first = bytes.substr(0, 256);
    const auto others = std::ranges::count_if(
        first, [](unsigned char c) { return (c < 0x20 || c > 0x7f) && c != '\n' && c != '\r' && c != '\t'; });
    return static_cast<double>(others) / static_cast<double>(first.size()) < 0.05;
}

}  // namespace

void check_ply(const std::filesystem::path& file, std::string_view bytes) { PlyChecker(file, bytes).check(); }

void check_stl(const std::filesystem::path& file, std::string_view bytes) {
    if (is_text_to_vtk(bytes)) {
        std::string_view begin = bytes;
        if (take_word(begin) != "solid" || !is_printable(bytes))
            reject_mesh(file, "is text, which in an .stl begins with \"solid\"");
        return;
    }
    constexpr std::size_t header = 80, triangle = 50;
    if (bytes.size() < header + 4) reject_mesh(file, "is cut short");
    std::uint32_t count = 0;
    for (std::size_t k = 0; k < 4; ++k)
        count |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[header + k])) << (8 * k);
    if ((bytes.size() - header - 4) / triangle < count)
        reject_mesh(file, fmt::format("claims {} triangles, more than its {} bytes can hold", count, bytes.size()));
}

}  // namespace waterlight
