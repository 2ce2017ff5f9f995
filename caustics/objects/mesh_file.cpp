#include "caustics/objects/mesh_file.hpp"

#include <fmt/format.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <iterator>

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
    std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    if (bytes.size() != size) reject_mesh(file, "cannot be read whole");
    return bytes;
}

/// Polygons with corners that are there.
void require_sound(const std::filesystem::path& file, vtkPolyData& data) {
    const vtkIdType points = data.GetNumberOfPoints();
    for (vtkIdType k = 0; k < points; ++k) {
        const double* p = data.GetPoint(k);
        if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
            reject_mesh(file, fmt::format("corner {} is not finite", k));
    }
    if (data.GetNumberOfPolys() == 0 && data.GetNumberOfStrips() == 0) reject_mesh(file, "has no triangle");
    for (vtkCellArray* cells : {data.GetPolys(), data.GetStrips()}) {
        const auto walk = vtk::TakeSmartPointer(cells->NewIterator());
        for (walk->GoToFirstCell(); !walk->IsDoneWithTraversal(); walk->GoToNextCell()) {
            vtkIdType count = 0;
            const vtkIdType* corners = nullptr;
            walk->GetCurrentCell(count, corners);
            for (vtkIdType k = 0; k < count; ++k)
                if (corners[k] < 0 || corners[k] >= points)
                    reject_mesh(file, fmt::format("names corner {} of {}", corners[k], points));
        }
    }
}

/// Reads without a word on the terminal.
template <class Reader>
vtkSmartPointer<vtkPolyData> read_by(const std::filesystem::path& file) {
    vtkNew<Reader> reader;
    std::string complaint;
    vtkNew<vtkCallbackCommand> listener;
    listener->SetClientData(&complaint);
    listener->SetCallback([](vtkObject*, unsigned long, void* client, void*) {
        *static_cast<std::string*>(client) = "is not what its ending says, or is cut short";
    });
    for (vtkObject* speaks : {static_cast<vtkObject*>(reader), static_cast<vtkObject*>(reader->GetExecutive())}) {
        speaks->AddObserver(vtkCommand::ErrorEvent, listener);
        speaks->AddObserver(vtkCommand::WarningEvent, listener);
    }
    reader->SetFileName(file.c_str());
    reader->Update();
    if (!complaint.empty()) reject_mesh(file, complaint);
    vtkSmartPointer<vtkPolyData> data = reader->GetOutput();
    require_sound(file, *data);
    // Filters copy what lies at the corners, of which a reader may have too little.
    data->GetPointData()->Initialize();
    data->GetCellData()->Initialize();
    return data;
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

vtkSmartPointer<vtkPolyData> polygons_in(const std::filesystem::path& file, std::string_view ending) {
    const std::string bytes = bytes_of(file);
    if (ending == ".obj") {
        auto data = poly_data(read_obj(file, bytes));
        require_sound(file, *data);
        return data;
    }
    if (ending == ".ply") {
        check_ply(file, bytes);
        return read_by<vtkPLYReader>(file);
    }
    check_stl(file, bytes);
    return read_by<vtkSTLReader>(file);
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
    Mesh mesh = mesh_of(*cleaned(*polygons_in(file, ending)), scale);
    if (mesh.triangles.empty()) reject_mesh(file, "has no triangle with an area");
    if (smooth) add_normals(mesh);
    return mesh;
}

}  // namespace waterlight
