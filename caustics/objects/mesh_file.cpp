#include "caustics/objects/mesh_file.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCleanPolyData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>

#include "caustics/objects/mesh_text.hpp"

namespace waterlight {

namespace {

std::string bytes_of(const std::filesystem::path& file) {
    constexpr std::uintmax_t most = std::uintmax_t{1} << 30;
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error) reject_mesh(file, "cannot be read: " + error.message());
    if (size == 0) reject_mesh(file, "is empty");
    if (size > most) reject_mesh(file, fmt::format("has {} bytes; allowed: at most {}", size, most));
    std::ifstream stream(file, std::ios::binary);
    std::string bytes(size, '\0');
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(size))) reject_mesh(file, "cannot be read whole");
    return bytes;
}

Polygons polygons_in(const std::filesystem::path& file, std::string_view ending) {
    const std::string bytes = bytes_of(file);
    Polygons polygons = ending == ".obj"   ? read_obj(file, bytes)
                        : ending == ".ply" ? read_ply(file, bytes)
                                           : read_stl(file, bytes);
    const auto is_finite = [](glm::dvec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
    const auto wrong = std::ranges::find_if_not(polygons.corners, is_finite);
    if (wrong != polygons.corners.end())
        reject_mesh(file, fmt::format("corner {} is not finite", wrong - polygons.corners.begin()));
    if (polygons.ends.empty()) reject_mesh(file, "has no triangle");
    return polygons;
}

vtkSmartPointer<vtkPolyData> poly_data(const Polygons& polygons) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const glm::dvec3& p : polygons.corners) points->InsertNextPoint(p.x, p.y, p.z);
    vtkNew<vtkCellArray> faces;
    std::size_t begin = 0;
    for (const std::size_t end : polygons.ends) {
        faces->InsertNextCell(static_cast<int>(end - begin));
        for (; begin < end; ++begin) faces->InsertCellPoint(polygons.named[begin]);
    }
    const auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(faces);
    return data;
}

/// Triangles alone, each corner once.
vtkSmartPointer<vtkPolyData> cleaned(vtkPolyData& data) {
    vtkNew<vtkTriangleFilter> triangles;
    triangles->PassVertsOff();
    triangles->PassLinesOff();
    triangles->SetInputData(&data);
    vtkNew<vtkCleanPolyData> clean;
    clean->SetTolerance(0);
    clean->SetInputConnection(triangles->GetOutputPort());
    clean->Update();
    return clean->GetOutput();
}

Mesh mesh_of(vtkPolyData& data, double scale) {
    Mesh mesh;
    for (vtkIdType k = 0; k < data.GetNumberOfPoints(); ++k) {
        const double* p = data.GetPoint(k);
        mesh.corners_m.emplace_back(scale * p[0], scale * p[1], scale * p[2]);
    }
    const auto walk = vtk::TakeSmartPointer(data.GetPolys()->NewIterator());
    for (walk->GoToFirstCell(); !walk->IsDoneWithTraversal(); walk->GoToNextCell()) {
        vtkIdType count = 0;
        const vtkIdType* corners = nullptr;
        walk->GetCurrentCell(count, corners);
        if (count == 3) mesh.triangles.emplace_back(corners[0], corners[1], corners[2]);
    }
    return mesh;
}

void add_normals(Mesh& mesh) {
    mesh.normals.assign(mesh.corners_m.size(), glm::dvec3(0));
    const auto at = [](int corner) { return static_cast<std::size_t>(corner); };
    for (const glm::ivec3& t : mesh.triangles) {
        const glm::dvec3 a = mesh.corners_m[at(t.x)], b = mesh.corners_m[at(t.y)], c = mesh.corners_m[at(t.z)];
        const glm::dvec3 area = glm::cross(b - a, c - a);
        for (int k = 0; k < 3; ++k) mesh.normals[at(t[k])] += area;
    }
    for (glm::dvec3& n : mesh.normals) n = glm::length(n) > 0 ? glm::normalize(n) : glm::dvec3(0, 0, 1);
}

}  // namespace

Mesh read_mesh(const std::filesystem::path& file, double scale, bool smooth) {
    std::string ending = file.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
    const bool known = ending == ".obj" || ending == ".ply" || ending == ".stl";
    if (!known) reject_mesh(file, fmt::format("ends in \"{}\"; allowed: .obj, .ply or .stl", ending));
    Mesh mesh = mesh_of(*cleaned(*poly_data(polygons_in(file, ending))), scale);
    if (mesh.triangles.empty()) reject_mesh(file, "has no triangle with an area");
    if (smooth) add_normals(mesh);
    return mesh;
}

}  // namespace waterlight
