// Files of ground heights: what is refused, and that damage does no harm.
#include <cmath>

#include "tests/support/ground_files.hpp"

namespace waterlight::testing {
namespace {

const Grid four_cells = make_grid(2, 2, 2, 2);

std::string esri(const std::string& text) { return ground_complaint(".asc", text, four_cells); }
std::string xyz(const std::string& text) { return ground_complaint(".xyz", text, four_cells); }

const std::string header = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n";

TEST(EsriReader, TakesEveryHeader) {
    for (const std::string& text :
         {header + "3 4\n1 2\n",
          std::string("NCOLS 2\r\nNROWS 2\r\nXLLCENTER 0.5\r\nYLLCENTER .5\r\nCELLSIZE 1\r\n3 4\r\n1 2"),
          std::string("nrows 2 ncols 2 dx 1 dy 1.0 xllcorner 0 yllcenter 0.5 nodata_value nan 3 4 1 +2e0")}) {
        const Field<double> read = read_text(".ASC", text, four_cells);
        EXPECT_EQ(read(0, 0), 1) << text;
        EXPECT_EQ(read(1, 0), 2) << text;
        EXPECT_EQ(read(0, 1), 3) << "rows go from north to south: " << text;
        EXPECT_EQ(read(1, 1), 4) << text;
    }
}

TEST(EsriReader, SaysWhatIsWrongWithAHeader) {
    EXPECT_EQ(esri("ncols 2\nrows 2\n"),
              ":2: found \"rows\"; a number or one of ncols, nrows, xllcorner, xllcenter, yllcorner, yllcenter, "
              "cellsize, dx, dy and NODATA_value is wanted");
    EXPECT_EQ(esri("ncols two\n"), ":1: ncols must be a finite number, found \"two\"");
    EXPECT_EQ(esri("ncols 2\nncols"), ":2: ncols must be a finite number, found \"\"");
    EXPECT_EQ(esri("ncols 2\nncols 2\n"), ":2: ncols is there twice");
    EXPECT_EQ(esri("ncols 2\nnrows 2\nyllcorner 0\ncellsize 1\n1 2 3 4\n"),
              ": the header of an ESRI ASCII grid lacks xllcenter");
    EXPECT_EQ(esri("nrows 2\n1 2 3 4\n"), ": the header of an ESRI ASCII grid lacks ncols");
    EXPECT_EQ(esri("ncols 2.5\nnrows 2\n1 2 3 4\n"),
              ": ncols must be a whole number from 1 to what its 26 bytes can hold, found 2.5");
    EXPECT_EQ(esri("ncols 2000000000\nnrows 2000000000\n1"),
              ": ncols must be a whole number from 1 to what its 35 bytes can hold, found 2e+09");
    EXPECT_EQ(esri("ncols 20\nnrows 20\nxllcorner 0\nyllcorner 0\ncellsize 1\n1"),
              ": claims 400 cells, more than its 54 bytes can hold");
    EXPECT_EQ(esri("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 0\n1 2 3 4\n"),
              ": cellsize must be above 0, found 0");
    EXPECT_EQ(esri(""), ": the header of an ESRI ASCII grid lacks ncols");
    EXPECT_EQ(esri("ncols 2\nnrows 2\nxllcorner 1e99\nyllcorner 0\ncellsize 1\n1 2 3 4\n"),
              ": its points must lie within 1e12 m of its origin and be 1e-9 m or more apart; found the first at "
              "(1e+99, 0.5) and spacings 1, 1");
}

TEST(EsriReader, SaysWhatIsWrongWithHeights) {
    EXPECT_EQ(esri(header + "1 2\n3\n"), ": ends after 3 of 4 values");
    EXPECT_EQ(esri(header + "1 2\n3 4\n5\n"), ":8: goes on with \"5\" after the 4 values announced");
    EXPECT_EQ(esri(header + "1 2\n3 4m\n"), ":7: a height is wanted, found \"4m\"");
    EXPECT_EQ(esri(header + "1 2\n3 inf\n"),
              ":7: heights must be finite numbers, found inf at (1.5, 0.5) of the file, (1.5, 0.5) m of the domain");
    EXPECT_EQ(esri(header + "1 2\n3 -9999\n"),
              ":7: found no data (-9999) at (1.5, 0.5) of the file, (1.5, 0.5) m of the domain; outside = \"extend\" "
              "would take the nearest data there");
    EXPECT_EQ(esri(header + std::string(70000, '7')), ":6: holds a word of more than 65536 characters");
}

TEST(EsriReader, NeedsNoDataOutsideTheDomain) {
    const Field<double> read =
        read_text(".asc", "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n3 4 -9999\n1 2 -9999\n", four_cells);
    EXPECT_EQ(read(1, 1), 4);
}

TEST(XyzReader, TakesAnyOrderHeadingsAndCommas) {
    for (const std::string& text :
         {std::string("x(m) y(m) z(m)\n1.5 .5 2\n0.5,1.5,3\n\n.5 .5 1\n1.5 , 1.5 4"),
          std::string("# made up\r\nx,y,z\r\n0.5,0.5,1\r\n1.5,0.5,2\r\n0.5,1.5,3\r\n1.5,1.5,4\r\n")}) {
        const Field<double> read = read_text(".csv", text, four_cells);
        EXPECT_EQ(read(0, 0), 1) << text;
        EXPECT_EQ(read(1, 0), 2) << text;
        EXPECT_EQ(read(0, 1), 3) << text;
        EXPECT_EQ(read(1, 1), 4) << text;
    }
}

TEST(XyzReader, SaysWhatIsWrongAndWhere) {
    EXPECT_EQ(xyz(".5 .5 1\n1.5 .5\n"), ":2: three numbers are wanted, x, y and z; found \"1.5 .5\"");
    EXPECT_EQ(xyz(".5 .5 1\n1.5 .5 2 7\n"), ":2: three numbers are wanted, x, y and z; found \"1.5 .5 2 7\"");
    EXPECT_EQ(xyz(".5 .5 1\n1.5 .5 2z\n"), ":2: three numbers are wanted, x, y and z; found \"1.5 .5 2z\"");
    EXPECT_EQ(xyz(".5 .5 1\nnan .5 2\n"), ":2: finite numbers are wanted, or NaN for no data as z; found \"nan .5 2\"");
    EXPECT_EQ(xyz(""), ": holds no line of three numbers, x, y and z");
    EXPECT_EQ(xyz("x y z\n"), ": holds no line of three numbers, x, y and z");
    EXPECT_EQ(xyz("1 1 1\n1 2 3\n"), ": all its points have the same x; a lattice has two x or more");
    EXPECT_EQ(xyz(".5 .5 1\n1.5 .5 2\n.5 1.5 3\n1.5 1.5 4\n.5 .5 5\n"), ":5: the point (0.5, 0.5) is there twice");
    EXPECT_EQ(xyz(".5 .5 1\n1.5 .5 2\n.5 1.5 3\n1.5 1.5 nan\n"),
              ":4: found no data at (1.5, 1.5) of the file, (1.5, 1.5) m of the domain; outside = \"extend\" would "
              "take the nearest data there");
    EXPECT_EQ(xyz(".5 .5 1\n1.5 .5 2\n.5 1.5 3\n"),
              ": lacks points at the cell at (1.5, 1.5) m of the domain; outside = \"extend\" would take the nearest "
              "data there");
}

TEST(XyzReader, RefusesScatteredPoints) {
    EXPECT_EQ(xyz("0 0 1\n1 0 1\n2.5 0 1\n0 1 1\n1 1 1\n2.5 1 1\n"),
              ": its points are no lattice: x = 1 stands where evenly spaced columns and rows have x = 1.25; "
              "scattered points must be gridded first");
    EXPECT_EQ(xyz("0 0 1\n1 1 1\n2 2 1\n3 3 1\n4 4 1\n"),
              ": its points are no lattice: 4 of them have 4 different x and 4 different y; scattered points must be "
              "gridded first");
    std::string many;
    for (int i = 0; i < 20000; ++i) many += fmt::format("{} {} 1\n", std::cos(i), std::sin(i));
    EXPECT_NE(xyz(many).find("its points are no lattice"), std::string::npos);
}

TEST(GroundFiles, SayThatTheyDoNotCoverTheDomain) {
    const Grid wide = make_grid(4, 2, 4, 2);
    const Field<double> heights = sampled(four_cells, [](double x, double) { return x; });
    for (const char* extension : {".vti", ".asc", ".xyz"}) {
        EXPECT_EQ(ground_complaint(extension, ground_text(extension, four_cells, heights), wide),
                  ": covers [0, 2] x [0, 2] m, and not the cell at (2.5, 0.5) m of the domain, [0, 4] x [0, 2] m; "
                  "outside = \"extend\" would take the nearest data there");
    }
    GroundFile file;
    file.offset_m = {NAN, 0};
    EXPECT_EQ(ground_complaint(".asc", esri_text(four_cells, heights), four_cells, file),
              ": offset_m and datum_m must be finite numbers, found (nan, 0) and 0");
    file.offset_m = {0, 0};
    file.outside = OutsideFile::extend;
    EXPECT_EQ(ground_complaint(".asc", header + "-9999 -9999 -9999 -9999", four_cells, file),
              ": has no data in the domain");
}

TEST(GroundFiles, SayWhichAreRead) {
    EXPECT_EQ(ground_complaint(".grd", "", four_cells),
              ": ground is read from .vti, .asc (ESRI ASCII grid), .xyz, .txt, .csv or .dat (lines of x, y, z); found "
              "the extension \".grd\"");
    const TemporaryFolder folder;
    for (const char* extension : {".vti", ".asc", ".xyz"}) {
        GroundFile file;
        file.path = folder / (std::string("missing") + extension);
        EXPECT_NE(complaint_of(file.path, [&] { read_ground(file, four_cells); }).find("No such file"),
                  std::string::npos);
    }
}

TEST(GroundFiles, SayWhatIsWrongWithAnImage) {
    const Field<double> heights = sampled(four_cells, [](double x, double) { return x; });
    EXPECT_EQ(ground_complaint(".vti", vti_text(four_cells, heights, "depth"), four_cells),
              ": has no array \"bed\"; found: depth");
    Field<double> holes = heights.clone();
    holes(1, 0) = NAN;
    EXPECT_EQ(ground_complaint(".vti", vti_text(four_cells, holes), four_cells),
              ": lacks points at the cell at (1.5, 0.5) m of the domain; outside = \"extend\" would take the nearest "
              "data there");
    GroundFile file;
    file.outside = OutsideFile::extend;
    EXPECT_EQ(read_text(".vti", vti_text(four_cells, holes), four_cells, file)(1, 0), 0.5);
}

class DamagedGround : public ::testing::TestWithParam<const char*> {};

TEST_P(DamagedGround, IsReadOrRefused) {
    const std::string extension = GetParam();
    const TemporaryFolder folder;
    GroundFile file;
    file.path = folder / ("bed" + extension);
    const Grid from = make_grid(7, 5, 3.5, 2.5);
    const std::string whole =
        ground_text(extension, from, sampled(from, [](double x, double y) { return 0.25 * x - y; }));
    ::testing::internal::CaptureStderr();
    for (const OutsideFile outside : {OutsideFile::refuse, OutsideFile::extend}) {
        file.outside = outside;
        expect_survives_damage(file.path, whole, 4000, [&] { read_ground(file, make_grid(9, 4, 3, 2)); });
    }
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

INSTANTIATE_TEST_SUITE_P(Formats, DamagedGround, ::testing::Values(".vti", ".asc", ".xyz"),
                         [](const auto& tested) { return std::string(tested.param + 1); });

}  // namespace
}  // namespace waterlight::testing
