// Corners and faces of a .ply (Turk 1994, "The PLY polygon file format"). VTK's reader (9.1) trusts what the header
// says: it reads beyond its arrays where that does not hold, and does not pass over elements that it does not know.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "caustics/objects/mesh_file.hpp"
#include "caustics/objects/mesh_text.hpp"
#include "sim/message.hpp"

namespace waterlight {

namespace {

enum class Encoding { text, little_endian, big_endian };
enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class Role { none, x, y, z, corners };

struct Property {
    Type type{};
    std::optional<Type> count;  ///< of the number before a list
    Role role = Role::none;
};

struct Element {
    std::string_view name;
    std::uint64_t rows = 0;
    std::vector<Property> properties;

    bool has(Role role) const { return std::ranges::find(properties, role, &Property::role) != properties.end(); }
};

bool is_float(Type type) { return type == Type::float32 || type == Type::float64; }

std::optional<Type> type_named(std::string_view name) {
    constexpr std::pair<std::string_view, Type> types[]{
        {"char", Type::int8},     {"int8", Type::int8},       {"uchar", Type::uint8},    {"uint8", Type::uint8},
        {"short", Type::int16},   {"int16", Type::int16},     {"ushort", Type::uint16},  {"uint16", Type::uint16},
        {"int", Type::int32},     {"int32", Type::int32},     {"uint", Type::uint32},    {"uint32", Type::uint32},
        {"float", Type::float32}, {"float32", Type::float32}, {"double", Type::float64}, {"float64", Type::float64}};
    for (const auto& [word, type] : types)
        if (word == name) return type;
    return std::nullopt;
}

Role role_of(std::string_view element, std::string_view property, bool is_list) {
    if (element == "face" && is_list && (property == "vertex_indices" || property == "vertex_index"))
        return Role::corners;
    if (element != "vertex" || is_list) return Role::none;
    return property == "x" ? Role::x : property == "y" ? Role::y : property == "z" ? Role::z : Role::none;
}

class PlyReader {
  public:
    PlyReader(const std::filesystem::path& file, std::string_view bytes) : file_(file), lines_(file, bytes) {}

    Polygons read() {
        read_header();
        require_mesh();
        bytes_ = lines_.rest();
        for (const Element& element : elements_)
            for (std::uint64_t row = 0; row < element.rows; ++row) read_row(element);
        return std::move(polygons_);
    }

  private:
    // The header

    void read_header() {
        lines_.require(lines_.next() == "ply", "it is not \"ply\", with which a .ply begins");
        read_encoding();
        while (true) {
            if (lines_.at_end()) reject_mesh(file_, "is cut short: its header has no end");
            std::string_view line = lines_.next();
            const std::string_view word = take_word(line);
            if (word == "end_header") return;
            if (word == "element")
                add_element(line);
            else if (word == "property")
                add_property(line);
            else
                lines_.require(word == "comment" || word == "obj_info",
                               fmt::format("\"{}\" is not known in a header", said(word)));
        }
    }

    void read_encoding() {
        std::string_view line = lines_.next();
        lines_.require(take_word(line) == "format", "it is no format, which comes second in a .ply");
        const std::string_view name = take_word(line), version = take_word(line);
        encoding_ = name == "binary_little_endian" ? Encoding::little_endian
                    : name == "binary_big_endian"  ? Encoding::big_endian
                                                   : Encoding::text;
        lines_.require((encoding_ != Encoding::text || name == "ascii") && version == "1.0",
                       fmt::format("format \"{} {}\"; allowed: ascii, binary_little_endian or binary_big_endian, 1.0",
                                   said(name), said(version)));
    }

    void add_element(std::string_view line) {
        const std::string_view name = take_word(line), rows = take_word(line);
        const std::optional<std::uint64_t> count = number_in<std::uint64_t>(rows);
        lines_.require(!name.empty() && count,
                       fmt::format("{} elements \"{}\"; allowed: a name and a whole number", said(rows), said(name)));
        lines_.require((name != "vertex" && name != "face") || !element(name), "there is this element already");
        elements_.push_back({.name = name, .rows = *count, .properties = {}});
    }

    void add_property(std::string_view line) {
        lines_.require(!elements_.empty(), "it is a property of no element");
        Element& element = elements_.back();
        Property property;
        std::string_view type = take_word(line);
        const bool is_list = type == "list";
        if (is_list) {
            property.count = require_type(take_word(line));
            type = take_word(line);
        }
        property.type = require_type(type);
        property.role = role_of(element.name, take_word(line), is_list);
        const bool is_whole = !(property.count && is_float(*property.count)) &&
                              !(property.role == Role::corners && is_float(property.type));
        lines_.require(is_whole, "numbers of corners and lengths of lists cannot be of this type");
        lines_.require(property.role == Role::none || !element.has(property.role), "there is this property already");
        element.properties.push_back(property);
    }

    Type require_type(std::string_view name) const {
        const std::optional<Type> type = type_named(name);
        lines_.require(type.has_value(), fmt::format("\"{}\" is no type that a .ply has", said(name)));
        return *type;
    }

    const Element* element(std::string_view name) const {
        const auto found = std::ranges::find(elements_, name, &Element::name);
        return found == elements_.end() ? nullptr : &*found;
    }

    void require_mesh() {
        const Element *vertex = element("vertex"), *face = element("face");
        const auto require = [&](bool holds, std::string_view otherwise) {
            if (!holds) reject_mesh(file_, otherwise);
        };
        require(vertex && face, fmt::format("has no element \"{}\"", vertex ? "face" : "vertex"));
        require(vertex->has(Role::x) && vertex->has(Role::y) && vertex->has(Role::z),
                "has elements \"vertex\" without x, y or z");
        require(face->has(Role::corners), "has elements \"face\" without a list vertex_indices");
        // Each row has a byte at least, so that there is an end to them.
        for (const Element& e : elements_) {
            require(!e.properties.empty() || e.rows == 0, fmt::format("has elements \"{}\" of nothing", said(e.name)));
            require(e.rows <= lines_.rest().size(),
                    fmt::format("claims {} elements \"{}\", more than its bytes can hold", e.rows, said(e.name)));
        }
        corners_ = vertex->rows;
        polygons_.corners.reserve(corners_);
    }

    // Its rows

    void read_row(const Element& element) {
        begin_row(element);
        glm::dvec3 point(0);
        for (const Property& property : element.properties) {
            const double first = take(property.count.value_or(property.type));
            if (property.count)
                take_list(property, first);
            else if (property.role != Role::none)
                point[static_cast<int>(property.role) - static_cast<int>(Role::x)] = first;
        }
        if (encoding_ == Encoding::text) lines_.require(take_word(row_).empty(), "it has more than the header says");
        if (element.name == "vertex") polygons_.corners.push_back(point);
        if (element.name == "face") polygons_.ends.push_back(polygons_.named.size());
    }

    void begin_row(const Element& element) {
        for (row_ = {}; encoding_ == Encoding::text && row_.find_first_not_of(" \t") == std::string_view::npos;) {
            if (lines_.at_end())
                reject_mesh(file_, fmt::format("is cut short in its elements \"{}\"", said(element.name)));
            row_ = lines_.next();
        }
    }

    void take_list(const Property& property, double count) {
        if (!(count >= 0 && count <= UINT32_MAX && count == std::floor(count)))
            reject_row("a list has a length that is no whole number of its type");
        const bool is_corners = property.role == Role::corners;
        if (is_corners && count < 3) reject_row("a face has fewer than three corners");
        if (is_corners && count > most_corners)
            reject_row(fmt::format("a face has more than {} corners", most_corners));
        for (auto k = static_cast<std::uint32_t>(count); k > 0; --k) {
            const double value = take(property.type);
            if (!is_corners) continue;
            if (!(value >= 0 && value < static_cast<double>(corners_) && value == std::floor(value)))
                reject_row(fmt::format("a face names a corner that is none of its {}", corners_));
            polygons_.named.push_back(static_cast<int>(value));
        }
    }

    double take(Type type) {
        if (encoding_ == Encoding::text) return take_decimal();
        switch (type) {
            case Type::int8:
                return take_binary<std::int8_t>();
            case Type::uint8:
                return take_binary<std::uint8_t>();
            case Type::int16:
                return take_binary<std::int16_t>();
            case Type::uint16:
                return take_binary<std::uint16_t>();
            case Type::int32:
                return take_binary<std::int32_t>();
            case Type::uint32:
                return take_binary<std::uint32_t>();
            case Type::float32:
                return take_binary<float>();
            case Type::float64:
                return take_binary<double>();
        }
        return 0;
    }

    double take_decimal() {
        const std::optional<double> value = decimal_in(take_word(row_));
        lines_.require(value.has_value(), "it has no number where the header says one");
        return *value;
    }

    template <class Number>
    double take_binary() {
        std::array<char, sizeof(Number)> raw;
        if (bytes_.size() < raw.size()) reject_mesh(file_, "is cut short");
        std::ranges::copy(bytes_.substr(0, raw.size()), raw.begin());
        bytes_.remove_prefix(raw.size());
        if ((encoding_ == Encoding::big_endian) != (std::endian::native == std::endian::big)) std::ranges::reverse(raw);
        return static_cast<double>(std::bit_cast<Number>(raw));
    }

    [[noreturn]] void reject_row(std::string_view why) const {
        if (encoding_ == Encoding::text) lines_.reject(why);
        reject_mesh(file_, why);
    }

    static std::string said(std::string_view word) { return shortened(in_one_line(word), 60); }

    const std::filesystem::path& file_;
    MeshLines lines_;
    Encoding encoding_ = Encoding::text;
    std::vector<Element> elements_;
    std::uint64_t corners_ = 0;
    std::string_view row_;    ///< what is left of it in a text
    std::string_view bytes_;  ///< what is left of them else
    Polygons polygons_;
};

}  // namespace

Polygons read_ply(const std::filesystem::path& file, std::string_view bytes) { return PlyReader(file, bytes).read(); }

}  // namespace waterlight
