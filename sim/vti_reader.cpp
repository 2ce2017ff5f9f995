#include "sim/vti_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/vtk_xml.hpp"

namespace waterlight {

namespace {

/// Ranges of points, ends included.
struct Extent {
    int x0 = 0, x1 = 0, y0 = 0, y1 = 0, z0 = 0, z1 = 0;
    bool is_flat() const { return z1 <= static_cast<long long>(z0) + 1; }
};

/// One kind of data, on the cells or on the points, of a file: where its values lie.
struct Location {
    const char* element;
    bool cells;
    int count(int first, int last) const {
        // A sheet that is one point wide has one row of cells.
        return cells ? std::max(1, last - first) : last - first + 1;
    }
};

constexpr Location locations[] = {{"CellData", true}, {"PointData", false}};

/// A header may claim any size: no file of this many bytes can hold more points, at zlib's best compression.
void check_size(const VtkXml& file, const Extent& e) {
    constexpr double best_compression = 1032;
    const double layers = e.is_flat() ? 1 : static_cast<double>(e.z1) - e.z0 + 1;
    const double points = (static_cast<double>(e.x1) - e.x0 + 1) * (static_cast<double>(e.y1) - e.y0 + 1) * layers;
    if (points > best_compression * static_cast<double>(file.bytes())) {
        file.reject(fmt::format("claims {:.0f} points, more than its {} bytes can hold", points, file.bytes()));
    }
}

Extent extent_of(const VtkXml& file, vtkXMLDataElement& element, const char* attribute) {
    std::array<int, 6> e{};
    if (element.GetVectorAttribute(attribute, 6, e.data()) != 6) file.reject("has no sound " + std::string(attribute));
    if (e[1] < e[0] || e[3] < e[2] || e[5] < e[4]) file.reject("holds no points");
    const Extent extent{e[0], e[1], e[2], e[3], e[4], e[5]};
    check_size(file, extent);
    return extent;
}

std::array<double, 3> three_numbers(const VtkXml& file, vtkXMLDataElement& image, const char* attribute) {
    std::array<double, 3> numbers{};
    const bool sound = image.GetVectorAttribute(attribute, 3, numbers.data()) == 3 &&
                       std::ranges::all_of(numbers, [](double n) { return std::isfinite(n); });
    if (!sound) file.reject("has no sound " + std::string(attribute));
    return numbers;
}

/// The grid whose cells are the image's, or whose cell centres are its points.
Grid grid_of(const VtkXml& file, vtkXMLDataElement& image, const Extent& whole, const Location& at) {
    const auto origin = three_numbers(file, image, "Origin"), pitch = three_numbers(file, image, "Spacing");
    if (pitch[0] <= 0 || pitch[1] <= 0) file.reject("has a Spacing that is not positive");
    std::array<double, 9> direction{1, 0, 0, 0, 1, 0, 0, 0, 1};
    const std::array<double, 9> straight = direction;
    image.GetVectorAttribute("Direction", 9, direction.data());
    if (direction != straight) file.reject("is rotated; an image along x and y is wanted");
    const double to_corner = at.cells ? 0 : -0.5;
    return {at.count(whole.x0, whole.x1),
            at.count(whole.y0, whole.y1),
            pitch[0],
            pitch[1],
            origin[0] + (whole.x0 + to_corner) * pitch[0],
            origin[1] + (whole.y0 + to_corner) * pitch[1]};
}

std::vector<vtkXMLDataElement*> arrays_of(vtkXMLDataElement& piece, const Location& at) {
    vtkXMLDataElement* data = VtkXml::find(piece, at.element);
    return data != nullptr ? VtkXml::find_all(*data, "DataArray") : std::vector<vtkXMLDataElement*>{};
}

vtkXMLDataElement* array_named(vtkXMLDataElement& piece, const Location& at, const std::string& name) {
    for (vtkXMLDataElement* array : arrays_of(piece, at)) {
        if (VtkXml::attribute(*array, "Name") == name) return array;
    }
    return nullptr;
}

[[noreturn]] void reject_missing(const VtkXml& file, vtkXMLDataElement& piece, const std::string& name) {
    std::vector<std::string_view> found;
    for (const Location& at : locations) {
        for (vtkXMLDataElement* array : arrays_of(piece, at)) found.push_back(VtkXml::attribute(*array, "Name"));
    }
    const std::string list = found.empty() ? "no arrays" : fmt::format("{}", fmt::join(found, ", "));
    file.reject(fmt::format("has no array \"{}\"; found: {}", name, list));
}

void check_scalar(const VtkXml& file, vtkXMLDataElement& array) {
    int components = 1;
    array.GetScalarAttribute("NumberOfComponents", components);
    if (components == 1) return;
    file.reject(fmt::format("array \"{}\" has {} components; a scalar is wanted", VtkXml::attribute(array, "Name"),
                            components));
}

template <class Real>
std::vector<Real> numbers_of(VtkXml& file, vtkXMLDataElement& array, std::size_t count) {
    if constexpr (std::is_same_v<Real, float>) {
        return file.floats(array, count);
    } else {
        return file.doubles(array, count);
    }
}

/// A flat image has one, of cells or of points.
int layers_of(const Extent& e, const Location& at) { return e.is_flat() ? 1 : at.count(e.z0, e.z1); }

/// Copies one piece of the image to its place; returns how many values it held.
template <class Real>
std::size_t read_piece(VtkXml& file, vtkXMLDataElement& piece, const Extent& whole, const Location& at,
                       std::pair<const std::string&, Field<Real>&> wanted) {
    auto& [name, field] = wanted;
    const Extent part = extent_of(file, piece, "Extent");
    const int nx = at.count(part.x0, part.x1), rows = at.count(part.y0, part.y1);
    const int layers = layers_of(part, at);
    const bool inside = part.x0 >= whole.x0 && part.y0 >= whole.y0 && part.x0 - whole.x0 + nx <= field.nx() &&
                        part.y0 - whole.y0 + rows <= field.ny() && part.z0 == whole.z0 && part.z1 == whole.z1;
    // Rows of a volume lie layer after layer: its one piece is all of it.
    const bool all = part.y0 == whole.y0 && part.y1 == whole.y1;
    if (!inside || (layers > 1 && !all)) file.reject("has a piece outside its whole extent");
    const int ny = rows * layers;
    vtkXMLDataElement* array = array_named(piece, at, name);
    if (array == nullptr) reject_missing(file, piece, name);
    check_scalar(file, *array);
    const std::vector<Real> values =
        numbers_of<Real>(file, *array, static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
    for (int j = 0; j < ny; ++j) {
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(j) * nx, nx,
                    field.row(part.y0 - whole.y0 + j) + (part.x0 - whole.x0));
    }
    return values.size();
}

std::optional<double> time_of(VtkXml& file, vtkXMLDataElement& image) {
    vtkXMLDataElement* data = VtkXml::find(image, "FieldData");
    if (data == nullptr) return {};
    for (vtkXMLDataElement* array : VtkXml::find_all(*data, "DataArray")) {
        if (VtkXml::attribute(*array, "Name") == "TimeValue") return file.doubles(*array, 1).front();
    }
    return {};
}

template <class Real>
VtiScalars<Real> read_array(const std::filesystem::path& path, const std::string& name, bool volume = false) {
    VtkXml file(path, "ImageData");
    vtkXMLDataElement* image = VtkXml::find(file.root(), "ImageData");
    if (image == nullptr) file.reject("has no element ImageData");
    const std::vector<vtkXMLDataElement*> pieces = VtkXml::find_all(*image, "Piece");
    if (pieces.empty()) file.reject("has no element Piece");
    const Extent whole = extent_of(file, *image, "WholeExtent");
    if (!volume && !whole.is_flat()) file.reject("holds a volume; a flat image is wanted");
    const auto* const at = std::ranges::find_if(
        locations, [&](const Location& location) { return array_named(*pieces[0], location, name) != nullptr; });
    if (at == std::end(locations)) reject_missing(file, *pieces[0], name);

    VtiScalars<Real> field;
    field.grid = grid_of(file, *image, whole, *at);
    field.layers = layers_of(whole, *at);
    const double rows = static_cast<double>(field.grid.ny) * field.layers;
    if (rows > std::numeric_limits<int>::max()) file.reject("has too many layers");
    if (field.layers > 1 && pieces.size() > 1) file.reject("is a volume in pieces; one piece is wanted");
    field.values = Field<Real>(field.grid.nx, field.grid.ny * field.layers);
    std::size_t values = 0;
    for (vtkXMLDataElement* piece : pieces) values += read_piece<Real>(file, *piece, whole, *at, {name, field.values});
    if (values < field.values.size()) file.reject("has pieces that do not cover its whole extent");
    field.time_s = time_of(file, *image);
    return field;
}

}  // namespace

VtiField read_vti(const std::filesystem::path& path, const std::string& name) { return read_array<float>(path, name); }

VtiScalars<double> read_vti_double(const std::filesystem::path& path, const std::string& name) {
    return read_array<double>(path, name);
}

VtiScalars<double> read_vti_volume(const std::filesystem::path& path, const std::string& name) {
    return read_array<double>(path, name, true);
}

}  // namespace waterlight
