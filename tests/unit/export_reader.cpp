#include <fmt/format.h>
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataWriter.h>

#include <random>

#include "export/vti.hpp"
#include "sim/error.hpp"
#include "sim/vti_reader.hpp"
#include "tests/unit/export_support.hpp"

namespace waterlight::testing {
namespace {

namespace fs = std::filesystem;

enum class Mode { ascii, binary, appended };

void write(vtkImageData& image, const fs::path& path, Mode mode) {
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetFileName(path.c_str());
    writer->SetInputData(&image);
    if (mode == Mode::ascii) writer->SetDataModeToAscii();
    if (mode == Mode::binary) writer->SetDataModeToBinary();
    writer->Write();
}

void add(vtkDataArray& array, const char* name, vtkIdType tuples, vtkDataSetAttributes& to) {
    array.SetName(name);
    array.SetNumberOfTuples(tuples);
    for (vtkIdType i = 0; i < tuples; ++i) {
        for (int c = 0; c < array.GetNumberOfComponents(); ++c) array.SetComponent(i, c, 0.5 * static_cast<double>(i));
    }
    to.AddArray(&array);
}

/// What reading throws as an InputError; it must name the file.
std::string complaint(const fs::path& path, const std::function<void()>& read) {
    try {
        read();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        return error.what();
    }
    return "";
}

std::string vti_complaint(const fs::path& path, const std::string& name = "elevation") {
    return complaint(path, [&] { read_vti(path, name); });
}

TEST(VtiReader, TakesCellsAndPointsInFloatAndDoubleAndEveryMode) {
    for (const Mode mode : {Mode::ascii, Mode::binary, Mode::appended}) {
        const TemporaryFolder folder;
        vtkNew<vtkImageData> image;
        image->SetExtent(2, 8, 1, 5, 0, 0);  // 7 x 5 points, 6 x 4 cells
        image->SetOrigin(10, 20, 0);
        image->SetSpacing(0.5, 0.25, 1);
        vtkNew<vtkFloatArray> cells;
        add(*cells, "cells", 24, *image->GetCellData());
        vtkNew<vtkDoubleArray> points;
        add(*points, "points", 35, *image->GetPointData());
        write(*image, folder / "i.vti", mode);

        const VtiField c = read_vti(folder / "i.vti", "cells");
        EXPECT_EQ(c.grid, (Grid{6, 4, 0.5, 0.25, 11, 20.25}));
        EXPECT_EQ(c.values(5, 3), 0.5F * 23);
        EXPECT_FALSE(c.time_s.has_value());
        const VtiField p = read_vti(folder / "i.vti", "points");
        EXPECT_EQ(p.grid, (Grid{7, 5, 0.5, 0.25, 10.75, 20.125}));
        EXPECT_EQ(p.grid.x_m(0), 11) << "the first point is the first cell's centre";
        EXPECT_EQ(p.values(6, 4), 0.5F * 34);
        points->SetComponent(0, 0, 10000.1);
        write(*image, folder / "i.vti", mode);
        EXPECT_EQ(read_vti_double(folder / "i.vti", "points").values(0, 0), 10000.1);
        EXPECT_EQ(read_vti_double(folder / "i.vti", "cells").values(5, 3), 0.5 * 23);
    }
}

TEST(VtiReader, SaysWhatIsWrongWithAnArray) {
    const TemporaryFolder folder;
    const fs::path path = folder / "i.vti";
    vtkNew<vtkImageData> image;
    image->SetDimensions(4, 4, 1);
    vtkNew<vtkFloatArray> vector;
    vector->SetNumberOfComponents(3);
    add(*vector, "velocity", 9, *image->GetCellData());
    vtkNew<vtkIntArray> integers;
    add(*integers, "count", 16, *image->GetPointData());
    write(*image, path, Mode::appended);
    EXPECT_EQ(vti_complaint(path), path.string() + ": has no array \"elevation\"; found: velocity, count");
    EXPECT_NE(vti_complaint(path, "velocity").find("3 components"), std::string::npos);
    EXPECT_NE(vti_complaint(path, "count").find("Int32"), std::string::npos);
}

TEST(VtiReader, ReadsAVolumeLayerAfterLayerWhereOneIsWanted) {
    const TemporaryFolder folder;
    VtiFrame frame;
    frame.cells = {2, 3, 4};
    const Field<float> values = noise(24, 1, 1);
    frame.arrays.push_back({"plane", {values.values()}});
    write_vti(folder / "volume.vti", frame, Compression::none);
    const VtiScalars<double> read = read_vti_volume(folder / "volume.vti", "plane");
    EXPECT_EQ(read.layers, 4);
    EXPECT_EQ(read.grid.ny, 3);
    ASSERT_EQ(read.values.size(), 24U);
    for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(read.values.data()[i], values.data()[i]) << i;
    frame.cells = {4, 6, 0};
    write_vti(folder / "flat.vti", frame, Compression::none);
    EXPECT_EQ(read_vti_volume(folder / "flat.vti", "plane").layers, 1);
}

TEST(VtiReader, SaysWhatIsWrongWithAnImage) {
    const TemporaryFolder folder;
    VtiFrame frame;
    frame.cells = {3, 3, 3};
    const Field<float> values = noise(27, 1, 1);
    frame.arrays.push_back({"elevation", {values.values()}});
    write_vti(folder / "volume.vti", frame, Compression::none);
    EXPECT_NE(vti_complaint(folder / "volume.vti").find("volume"), std::string::npos);
    frame.cells = {9, 3, 0};
    frame.angle_deg = 10;
    write_vti(folder / "turned.vti", frame, Compression::none);
    EXPECT_NE(vti_complaint(folder / "turned.vti").find("rotated"), std::string::npos);
    EXPECT_NE(vti_complaint(folder / "missing.vti").find("No such file"), std::string::npos);
    fs::create_directory(folder / "folder.vti");
    EXPECT_NE(vti_complaint(folder / "folder.vti"), "");
}

TEST(VtiReader, RejectsElementsAndAttributesBeyondBoundsSilently) {
    const TemporaryFolder folder;
    const fs::path path = folder / "a.vti";
    const auto repeated = [](const char* text, int times) {
        std::string all;
        for (int n = 0; n < times; ++n) all += text;
        return all;
    };
    std::string attributes;
    for (int n = 0; n < 100000; ++n) attributes += fmt::format(" a{}=\"\"", n);
    ::testing::internal::CaptureStderr();
    for (const int deep : {64, 200000}) {
        put_bytes(path, "<VTKFile type=\"ImageData\">" + repeated("<a>", deep) + repeated("</a>", deep) +
                            "<b/><b><c/></b></VTKFile>");
        EXPECT_NE(vti_complaint(path).find("deep within one another"), std::string::npos) << vti_complaint(path);
    }
    put_bytes(path, "<VTKFile type=\"ImageData\">" + repeated("<a>", 63) + repeated("</a>", 63) + "</VTKFile>");
    EXPECT_NE(vti_complaint(path).find("no element ImageData"), std::string::npos) << vti_complaint(path);
    for (const char* text : {"<VTKFile type=\"ImageData\"><ImageData{}/><b/></VTKFile>", "<VTKFile{}><a/></VTKFile>"}) {
        put_bytes(path, fmt::format(fmt::runtime(text), attributes));
        EXPECT_NE(vti_complaint(path).find("100000 attributes"), std::string::npos) << vti_complaint(path);
    }
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

/// Cut anywhere, a file is rejected, and VTK prints nothing.
TEST(VtiReader, RejectsATruncatedFileSilently) {
    for (const Compression compression : {Compression::none, Compression::lz4, Compression::zlib}) {
        const TemporaryFolder folder;
        VtiFrame frame;
        frame.cells = {64, 48, 0};
        const Field<float> values = noise(64, 48, 1);
        frame.arrays.push_back({"elevation", {values.values()}});
        write_vti(folder / "whole.vti", frame, compression);
        const std::string whole = bytes_of(folder / "whole.vti");
        std::mt19937 random(3);
        std::vector<std::size_t> cuts{0, 1, 100, whole.size() / 2, whole.size() - 2};
        for (int i = 0; i < 60; ++i) cuts.push_back(random() % (whole.size() - 1));
        ::testing::internal::CaptureStderr();
        ::testing::internal::CaptureStdout();
        for (const std::size_t cut : cuts) {
            put_bytes(folder / "cut.vti", whole.substr(0, cut));
            EXPECT_NE(vti_complaint(folder / "cut.vti"), "") << "cut at " << cut << " of " << whole.size();
        }
        EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
        EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
    }
}

/// The sizes that stand before the data are not believed: VTK's own reader crashes on some.
TEST(VtiReader, RejectsDamagedSizes) {
    for (const Compression compression : {Compression::none, Compression::lz4, Compression::zlib}) {
        const TemporaryFolder folder;
        VtiFrame frame;
        frame.cells = {128, 96, 0};
        const Field<float> values = noise(128, 96, 1);
        frame.arrays.push_back({"elevation", {values.values()}});
        write_vti(folder / "whole.vti", frame, compression);
        const std::string whole = bytes_of(folder / "whole.vti");
        const std::size_t array = whole.find("Name=\"elevation\""), at = whole.find("offset=\"", array) + 8;
        const std::size_t data = whole.find("_", whole.find("<AppendedData")) + 1;
        const std::size_t sizes = data + std::stoul(whole.substr(at, 10));
        const std::size_t bytes = compression == Compression::none ? 8 : 32;
        for (std::size_t i = 0; i < bytes; ++i) {
            for (const char flip : {'\x01', '\x80', '\xff'}) {
                std::string damaged = whole;
                damaged[sizes + i] = static_cast<char>(damaged[sizes + i] ^ flip);
                put_bytes(folder / "damaged.vti", damaged);
                EXPECT_NE(vti_complaint(folder / "damaged.vti"), "") << "byte " << i << " of the sizes";
            }
        }
        std::string damaged = whole;
        damaged.replace(at, 1, "9999");
        put_bytes(folder / "damaged.vti", damaged);
        EXPECT_NE(vti_complaint(folder / "damaged.vti"), "") << "the offset";
    }
}

TEST(VtiReader, RejectsGarbageSilently) {
    const TemporaryFolder folder;
    const fs::path path = folder / "g.vti";
    const auto image_file = [](const char* extent, const char* spacing, const char* data) {
        return fmt::format(
            "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">"
            "<ImageData WholeExtent=\"{0}\" Origin=\"0 0 0\" Spacing=\"{1}\"><Piece Extent=\"{0}\">"
            "<CellData><DataArray type=\"Float32\" Name=\"elevation\" format=\"ascii\">{2}</DataArray></CellData>"
            "</Piece></ImageData></VTKFile>",
            extent, spacing, data);
    };
    put_bytes(path, image_file("0 2 0 1 0 0", "1 1 1", "5 6"));
    EXPECT_EQ(vti_complaint(path), "") << "the pattern of the others is sound";
    ::testing::internal::CaptureStderr();
    const std::vector<std::string> garbage{
        std::string(5000, '\xff'),
        "elevation,1,2,3\n",
        "<VTKFile type=\"PolyData\" version=\"1.0\"><PolyData/></VTKFile>",
        "<VTKFile type=\"ImageData\" version=\"1.0\"></VTKFile>",
        image_file("0 2 0 1 0 0", "1 1 1", "5"),
        image_file("0 2 0 1 0 0", "1 1 1", "five six"),
        image_file("0 2000000000 0 2000000000 0 0", "1 1 1", "5 6"),
        image_file("0 2 0 -9 0 0", "1 1 1", "5 6"),
        image_file("0 2 0 1 0 0", "0 1 1", "5 6"),
        image_file("0 2 0 1 0 0", "1 nan 1", "5 6"),
        image_file("0 2 0 1 0 0", "1 1 1", "5 6") + "<more/>",
    };
    for (const std::string& bytes : garbage) {
        put_bytes(path, bytes);
        EXPECT_NE(vti_complaint(path), "") << bytes.substr(0, 300);
    }
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(PvdReader, OrdersByTimeAndResolvesNames) {
    const TemporaryFolder folder;
    put_bytes(folder / "s.pvd",
              "<?xml version=\"1.0\"?><VTKFile type=\"Collection\"><Collection>"
              "<DataSet timestep=\"2.5\" group=\"\" part=\"0\" file=\"s/b.vti\"/>"
              "<DataSet timestep=\"-1e-3\" file=\"/abs/a.vti\"/></Collection></VTKFile>");
    const std::vector<TimedFile> files = read_pvd(folder / "s.pvd");
    ASSERT_EQ(files.size(), 2U);
    EXPECT_EQ(files[0].time_s, -1e-3);
    EXPECT_EQ(files[0].path, "/abs/a.vti");
    EXPECT_EQ(files[1].time_s, 2.5);
    EXPECT_EQ(files[1].path, folder / "s/b.vti");
}

TEST(PvdReader, RejectsWhatIsNoCollectionSilently) {
    const TemporaryFolder folder;
    const fs::path path = folder / "s.pvd";
    const auto collection = [](const std::string& sets) {
        return "<VTKFile type=\"Collection\"><Collection>" + sets + "</Collection></VTKFile>";
    };
    ::testing::internal::CaptureStderr();
    for (const std::string& bytes :
         {std::string(), std::string("nonsense"), std::string("<VTKFile type=\"Collection\"><Collection>"),
          std::string("<VTKFile type=\"ImageData\"/>"), collection(""), collection("<DataSet file=\"a.vti\"/>"),
          collection("<DataSet timestep=\"1\"/>"), collection("<DataSet timestep=\"soon\" file=\"a.vti\"/>"),
          collection("<DataSet timestep=\"nan\" file=\"a.vti\"/>")}) {
        put_bytes(path, bytes);
        EXPECT_NE(complaint(path, [&] { read_pvd(path); }), "") << bytes;
    }
    const fs::path missing = folder / "missing.pvd";
    EXPECT_NE(complaint(missing, [&] { read_pvd(missing); }).find("No such file"), std::string::npos);
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace waterlight::testing
