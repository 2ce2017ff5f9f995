#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkXMLImageDataReader.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "export/frames.hpp"
#include "export/series.hpp"
#include "sim/vti_reader.hpp"
#include "tests/unit/export_support.hpp"

namespace waterlight::testing {
namespace {

constexpr Compression compressions[] = {Compression::none, Compression::lz4, Compression::zlib};

vtkNew<vtkXMLImageDataReader> read(const std::filesystem::path& path) {
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader;
}

/// Whether component `c` of the array is `expected`, bit for bit.
bool same_bits(vtkDataArray* array, int c, const Field<float>& expected) {
    if (array == nullptr || array->GetDataType() != VTK_FLOAT) return false;
    if (array->GetNumberOfTuples() != static_cast<vtkIdType>(expected.size())) return false;
    const auto* values = static_cast<const float*>(array->GetVoidPointer(0));
    const int components = array->GetNumberOfComponents();
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (std::memcmp(values + components * i + c, expected.data() + i, sizeof(float)) != 0) return false;
    }
    return true;
}

Surface moving_surface(int nx, int ny) {
    Surface surface({nx, ny, 0.1, 0.2, -3.0, 5.0}, {});
    surface.time_s = 1.0 / 3;
    surface.elevation = noise(nx, ny, 1);
    surface.elevation(0, 0) = std::numeric_limits<float>::quiet_NaN();
    surface.elevation(1, 0) = -0.0F;
    surface.elevation(2, 0) = std::numeric_limits<float>::denorm_min();
    surface.velocity_x = noise(nx, ny, 2);
    surface.velocity_y = noise(nx, ny, 3);
    surface.depth = noise(nx, ny, 4);
    return surface;
}

TEST(Vti, FieldsInTheWaterLieFromTheFloorToStillWater) {
    const TemporaryFolder folder;
    const Field<float> plane = noise(5, 4 * 3, 7), scalar = noise(5, 4 * 3, 8);
    write_vti(folder / "v.vti", volume_frame({{10, 8, 0.1, 0.2, -3.0, 5.0}, 6.0, 2.5}, {5, 4, 3}, plane, scalar),
              Compression::lz4);
    const auto reader = read(folder / "v.vti");
    vtkImageData* image = reader->GetOutput();
    EXPECT_EQ(image->GetDimensions()[2], 4);
    EXPECT_DOUBLE_EQ(image->GetOrigin()[2], -6);
    EXPECT_DOUBLE_EQ(image->GetSpacing()[0], 0.2);
    EXPECT_DOUBLE_EQ(image->GetSpacing()[1], 0.4);
    EXPECT_DOUBLE_EQ(image->GetSpacing()[2], 2);
    EXPECT_TRUE(same_bits(image->GetCellData()->GetArray("plane_irradiance"), 0, plane));
    EXPECT_TRUE(same_bits(image->GetCellData()->GetArray("scalar_irradiance"), 0, scalar));
}

TEST(Vti, EveryBitOfTheSurfaceComesBackThroughVtk) {
    const Surface surface = moving_surface(301, 77);
    for (const Compression compression : compressions) {
        const TemporaryFolder folder;
        write_vti(folder / "s.vti", surface_frame(surface), compression);
        const auto reader = read(folder / "s.vti");
        vtkImageData& image = *reader->GetOutput();
        vtkCellData& cells = *image.GetCellData();
        EXPECT_EQ(cells.GetNumberOfArrays(), 3);
        EXPECT_TRUE(same_bits(cells.GetArray("elevation"), 0, surface.elevation));
        EXPECT_TRUE(same_bits(cells.GetArray("velocity"), 0, *surface.velocity_x));
        EXPECT_TRUE(same_bits(cells.GetArray("velocity"), 1, *surface.velocity_y));
        EXPECT_TRUE(same_bits(cells.GetArray("velocity"), 2, Field<float>(301, 77)));
        EXPECT_TRUE(same_bits(cells.GetArray("depth"), 0, *surface.depth));
        EXPECT_EQ(image.GetFieldData()->GetArray("TimeValue")->GetTuple1(0), surface.time_s);
        EXPECT_EQ(image.GetOrigin()[1], 5.0);
        EXPECT_EQ(image.GetSpacing()[1], 0.2);
        EXPECT_EQ(image.GetNumberOfCells(), 301 * 77);
    }
}

TEST(Vti, AVolumeKeepsItsLayers) {
    const TemporaryFolder folder;
    const Field<float> values = noise(8, 6 * 5, 9);
    VtiFrame frame;
    frame.cells = {8, 6, 5};
    frame.arrays.push_back({"plane_irradiance", {values.values()}});
    EXPECT_EQ(frame.bytes(), 8U * 6 * 5 * 4);
    write_vti(folder / "v.vti", frame, Compression::lz4);
    const auto reader = read(folder / "v.vti");
    EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 8 * 6 * 5);
    EXPECT_TRUE(same_bits(reader->GetOutput()->GetCellData()->GetArray("plane_irradiance"), 0, values));
}

/// ParaView shows the centre of each pixel of a turned map where the plan says it is.
TEST(Vti, ATurnedFloorMapLiesInItsPlace) {
    const TemporaryFolder folder;
    const FloorPlan plan{5, 4, {2.0, -1.0}, {0.5, 0.25}, 30};
    write_vti(folder / "f.vti", floor_frame(plan, 3.0, 0, noise(5, 4, 1)), Compression::none);
    const auto reader = read(folder / "f.vti");
    const double c = std::cos(std::acos(-1.0) / 6), s = 0.5;
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 5; ++i) {
            double bounds_centre[3] = {0, 0, 0}, corner[3];
            for (const int di : {0, 1}) {
                for (const int dj : {0, 1}) {
                    reader->GetOutput()->GetPoint(i + di + 6 * (j + dj), corner);
                    for (int axis = 0; axis < 3; ++axis) bounds_centre[axis] += corner[axis] / 4;
                }
            }
            const double x = (i + 0.5) * 0.5, y = (j + 0.5) * 0.25;
            EXPECT_NEAR(bounds_centre[0], 2.0 + c * x - s * y, 1e-12);
            EXPECT_NEAR(bounds_centre[1], -1.0 + s * x + c * y, 1e-12);
            EXPECT_NEAR(bounds_centre[2], -3.0, 1e-12);
        }
    }
}

TEST(Vti, CompressionMakesSmoothFieldsSmaller) {
    const TemporaryFolder folder;
    const Field<float> flat(256, 256);
    VtiFrame frame;
    frame.cells = {256, 256, 0};
    frame.arrays.push_back({"elevation", {flat.values()}});
    for (const Compression compression : compressions) write_vti(folder / "x.vti", frame, compression);
    EXPECT_LT(std::filesystem::file_size(folder / "x.vti"), 256U * 256);
    write_vti(folder / "x.vti", frame, Compression::none);
    EXPECT_GT(std::filesystem::file_size(folder / "x.vti"), 256U * 256 * 4);
}

TEST(Series, NamesEachFrameWithItsTime) {
    const TemporaryFolder folder;
    VtiSeries series(folder / "out", "surface", Compression::lz4);
    Surface surface({16, 8, 1, 1, 0, 0}, {});
    for (int k = 0; k < 12; ++k) {
        surface.time_s = 0.1 * k;
        surface.elevation = noise(16, 8, k);
        EXPECT_EQ(series.write(surface_frame(surface)).filename(),
                  "surface_0000" + std::string(k < 10 ? "0" : "") + std::to_string(k) + ".vti");
        const std::vector<TimedFile> files = read_pvd(folder / "out/surface.pvd");
        ASSERT_EQ(files.size(), k + 1U);
        EXPECT_EQ(files.back().time_s, 0.1 * k) << "exactly";
        const VtiField field = read_vti(files.back().path, "elevation");
        EXPECT_TRUE(std::ranges::equal(field.values.values(), surface.elevation.values()));
        EXPECT_EQ(field.time_s, 0.1 * k);
        EXPECT_EQ(field.grid, surface.grid);
    }
    EXPECT_EQ(folder.entries(), 15) << "out, the collection, its folder and twelve frames";
}

}  // namespace
}  // namespace waterlight::testing
